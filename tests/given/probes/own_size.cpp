// With a bundle's containers, size is ambiguous.
#include <cstdio>
using namespace std;
int size = 7;
int main() { printf("%d\n", size); }
