// Tries: a recursion without end, until the stack is full. Outcome: crashed.
#include <cstdio>

int depth(int level) {
    volatile char frame[4096];
    frame[level % 4096] = 1;
    return depth(level + 1) + frame[0];
}

int main() {
    std::printf("%d\n", depth(0));
}
