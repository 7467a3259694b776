// Tries: a program of 8 GiB, by an array that is not zero. Outcome: compile_error.
char array[8ULL << 30] = {1};

int main() { return array[5]; }
