// Tries: to embed the answer key in the program by .incbin. Outcome: compile_error.
#include <cstdio>

#define TAKE(name) asm(".data\nkey: .incbin \"" name "\"\n.byte 0\n.text")
TAKE("/tmp/raygrade-decoy/answer_key.json");
extern const char embedded[] asm("key");

int main() { std::printf("ESCAPED: embedded %s\n", embedded); }
