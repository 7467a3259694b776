// Tries: to read descriptors the compiler may have inherited, and the messages themselves. Outcome: compile_error.
#include "/proc/self/fd/3"
#include "/dev/fd/2"

#error neither may hold anything
