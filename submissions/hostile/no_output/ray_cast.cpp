// Tries: to get away with printing nothing at all. Outcome: no_output.
int main() {}
