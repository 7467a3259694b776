// Tries: to include /dev/zero, which never ends. Outcome: compile_error.
#include "/dev/zero"

int main() {}
