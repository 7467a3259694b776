// None: M_PI is there under -std=c++17 too.
#include <cmath>
#include <cstdio>
int main() { std::printf("%.6f\n", M_PI); }
