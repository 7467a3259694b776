// Tries: to ask by #pragma GCC dependency whether the answer key is there, and how old it is. Outcome: compile_error.
#pragma GCC dependency "/tmp/raygrade-decoy/answer_key.json"
#include <cstdio>

int main() { std::puts("ESCAPED: the answer key is there"); }
