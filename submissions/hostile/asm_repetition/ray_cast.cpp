// Tries: a program of 8 GB, by .rept within .rept. Outcome: compile_error.
asm(".data\n.rept 1000000\n.rept 1000\n.quad 7\n.endr\n.endr\n.text");

int main() {}
