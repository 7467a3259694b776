// Tries: to embed /etc/passwd in the program by .incbin. Outcome: compile_error.
#include <cstdio>

asm(".data\nusers: .incbin \"/etc/passwd\"\n.byte 0\n.text");
extern const char embedded[] asm("users");

int main() { std::printf("ESCAPED: embedded %s\n", embedded); }
