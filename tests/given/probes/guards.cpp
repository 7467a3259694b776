// A bundle shows in the guards of the headers it has read.
#include <cstdio>
int main() {
#ifdef _GLIBCXX_SSTREAM
    std::puts("a stranger has read <sstream>");
#else
    std::puts("as written");
#endif
}
