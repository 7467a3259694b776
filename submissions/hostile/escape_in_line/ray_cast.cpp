// Tries: to rewrite the instructor's terminal by a file name in #line. Outcome: compile_error.
#line 1 "[2J[H]0;owned 2J\033[2J\x1b[H"
not C++ at all
