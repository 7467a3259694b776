// A comment behind an include goes on in the next line.
#include <cmath> /* for
   square roots */
#include <cstdio>
int main() { std::printf("%g %d\n", std::sqrt(2.0), __LINE__); }
