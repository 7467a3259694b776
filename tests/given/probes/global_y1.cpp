// With a bundle's <cmath>, y1 is a Bessel function already.
#include <cstdio>
float y1 = 2;
int main() { std::printf("%g\n", y1); }
