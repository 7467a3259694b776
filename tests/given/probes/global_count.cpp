// With a bundle's <algorithm>, count is ambiguous.
#include <cstdio>
using namespace std;
int count = 3;
int main() { printf("%d\n", count); }
