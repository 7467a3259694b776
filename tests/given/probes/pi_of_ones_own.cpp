// A bundle's <cmath> has M_PI, so the student's own, coarser one is not taken.
#include <cstdio>
#ifndef M_PI
#define M_PI 3.14
#endif
int main() { std::printf("%.6f\n", M_PI); }
