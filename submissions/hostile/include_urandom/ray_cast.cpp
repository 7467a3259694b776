// Tries: to include /dev/urandom, which never ends. Outcome: compile_error.
#include "/dev/urandom"

int main() {}
