// An include by macro is read as written.
#include <cstdio>
#define HEADER <cmath>
#include HEADER
int main() { std::printf("%g\n", std::sqrt(4.0)); }
