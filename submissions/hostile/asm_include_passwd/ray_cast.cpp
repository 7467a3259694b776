// Tries: to have the assembler quote /etc/passwd by .include. Outcome: compile_error.
asm(".include \"/etc/passwd\"");

int main() {}
