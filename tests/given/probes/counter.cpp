// A header that counts would be seen here.
#include <cstdio>
#include <glm/glm.hpp>
int main() { std::printf("%d %d\n", __COUNTER__, __COUNTER__); }
