// None: <cassert> is read anew each time it is included.
#include <cassert>
#define NDEBUG
#include <cstdio>
#include <cassert>
int main() {
    assert(false);
    std::puts("not asked");
}
