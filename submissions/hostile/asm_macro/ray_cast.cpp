// Tries: a macro of the assembler that calls itself twice. Outcome: compile_error.
asm(".macro twice depth\n.if \\depth\ntwice (\\depth-1)\ntwice (\\depth-1)\n.endif\n.quad 7\n.endm\ntwice 30");

int main() {}
