// Tries: to include what is typed at the instructor's terminal. Outcome: compile_error.
#include "/dev/stdin"

#error nothing was typed
