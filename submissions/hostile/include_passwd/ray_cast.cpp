// Tries: to have /etc/passwd quoted in the compiler's messages. Outcome: compile_error.
#include "/etc/passwd"

int main() {}
