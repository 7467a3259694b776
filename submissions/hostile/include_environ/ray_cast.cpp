// Tries: to have the environment quoted in the compiler's messages. Outcome: compile_error.
#include "/proc/self/environ"

#error an environment was read, if it was not empty
