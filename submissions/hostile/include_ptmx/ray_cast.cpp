// Tries: to let the compiler wait for ever at /dev/ptmx. Outcome: compile_error.
#include "/dev/ptmx"

int main() {}
