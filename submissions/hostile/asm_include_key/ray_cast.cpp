// Tries: to have the assembler quote the answer key by .include. Outcome: compile_error.
asm(".include \"/tmp/raygrade-decoy/answer_key.json\"");

int main() {}
