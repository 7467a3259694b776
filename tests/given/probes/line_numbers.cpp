// Lines and columns are as written, also in the built-in functions that ask the caller.
/* a comment
   of two lines */ #include <cstdio>
#include <cmath> /* one */ // two
void at(int line = __builtin_LINE(), const char* file = __builtin_FILE()) { std::printf("%s:%d\n", file, line); }
int main() {
    at(); at(
    );
}
