// After a bundle, private is private: <string> was read before it was redefined.
#define private public
#include <string>
#include <cstdio>
int main() {
    std::string text = "seen";
    std::puts(text._M_dataplus._M_p);
}
