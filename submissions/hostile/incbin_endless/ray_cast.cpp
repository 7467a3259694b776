// Tries: to embed a device without an end by .incbin. Outcome: compile_error.
asm(".data\n.incbin \"/dev/zero\"\n.incbin \"/dev/urandom\", 0, 0x200000000\n.text");

int main() {}
