// What looks like a directive or a comment in a literal is none.
#include <cstdio>
const char* text = R"(
#include <cmath>
// )";
#include <cmath>
int main() { std::puts(text); }
