// A bundle supplies the <cmath> that is missing: this does not compile.
#include <cstdio>
int main() { std::printf("%g\n", sqrt(2.0)); }
