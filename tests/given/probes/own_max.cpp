// With a bundle's <algorithm>, the call is ambiguous.
#include <cstdio>
using namespace std;
template <class T>
T max(T a, T b) {
    return a > b ? a : b;
}
int main() { printf("%d\n", max(1, 2)); }
