// Tries: a program of 8 GiB, by .space. Outcome: compile_error.
asm(".data\n.space 8589934592, 1\n.text");

int main() {}
