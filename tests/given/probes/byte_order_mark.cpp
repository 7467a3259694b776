// A mark of UTF-8 before everything.
#include <cstdio>
int main() { std::puts("marked"); }
