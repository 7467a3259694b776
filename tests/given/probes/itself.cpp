// A source that includes itself goes round.
#include <cstdio>
#ifndef ONCE
#define ONCE
#include "ray_cast.cpp"
#else
int main() { std::puts("once"); }
#endif
