// A macro changes what the headers' words mean.
#define SCALE(x) ((x) * 2)
#define start main
#include <cstdio>
int start() { std::printf("%d\n", SCALE(21)); }
