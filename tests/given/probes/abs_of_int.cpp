// With a bundle, abs may become that of floating-point numbers.
#include <cstdio>
#include <cstdlib>
int main() { std::printf("%g\n", static_cast<double>(abs(static_cast<int>(-2.7)))); }
