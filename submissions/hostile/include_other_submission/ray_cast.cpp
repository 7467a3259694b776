// Tries: to hand in another student's program by including it. Outcome: compile_error.
#include "/tmp/raygrade-decoy/other/ray_cast.cpp"
