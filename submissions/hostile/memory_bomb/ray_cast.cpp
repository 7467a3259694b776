// Tries: to use 2 GiB of memory. Outcome: memory_limit.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

int main() {
    alarm(20);
    for (int mebibytes = 0; mebibytes < 2048; ++mebibytes) {
        char* piece = static_cast<char*>(std::malloc(1 << 20));
        if (piece != nullptr) std::memset(piece, 1, 1 << 20);
        asm volatile("" : : "r"(piece) : "memory");
    }
    sleep(1);
    std::puts("ESCAPED: 2 GiB of memory in use");
}
