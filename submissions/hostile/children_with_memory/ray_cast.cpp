// Tries: eight children with 100 MB of memory each. Outcome: memory_limit.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

int main() {
    for (int i = 0; i < 8; ++i) {
        if (fork() != 0) continue;
        alarm(20);
        char* memory = static_cast<char*>(std::malloc(100'000'000));
        if (memory != nullptr) std::memset(memory, 1, 100'000'000);
        asm volatile("" : : "r"(memory) : "memory");
        sleep(2);
        _exit(0);
    }
    while (wait(nullptr) > 0) {
    }
    std::puts("ESCAPED: eight children had 100 MB each at one time");
}
