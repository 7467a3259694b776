// A comment that goes on by a backslash swallows an include.
#include <cstdio>
// and so on \
#include <no/such/header>
int main() { std::puts("fine"); }
