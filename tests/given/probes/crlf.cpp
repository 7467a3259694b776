// Line ends as on Windows.
#include <cstdio>
#include <cmath>
int main() { std::printf("%d\n", __LINE__); }
