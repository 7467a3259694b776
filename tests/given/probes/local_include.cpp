// A header that was not handed in is not there.
#include <cstdio>
#include "vector.h"
int main() {}
