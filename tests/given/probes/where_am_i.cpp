// The file, its depth and its line are as written.
#include <cstdio>

#include <cmath> // blanks
int main() { std::printf("%s %s %d %d\n", __FILE__, __BASE_FILE__, __INCLUDE_LEVEL__, __LINE__); }
