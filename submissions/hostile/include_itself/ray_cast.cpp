// Tries: to include itself twice, 200 levels deep. Outcome: compile_error.
#include "ray_cast.cpp"
#include "ray_cast.cpp"

int main() {}
