// Tries: to use 1 GiB in a process whose first thread has ended, which /proc shows as a zombie. Outcome: memory_limit.
#include <pthread.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

void* fill(void*) {
    usleep(20000);
    for (int mebibytes = 0; mebibytes < 1024; ++mebibytes) {
        char* piece = static_cast<char*>(std::malloc(1 << 20));
        if (piece != nullptr) std::memset(piece, 1, 1 << 20);
        asm volatile("" : : "r"(piece) : "memory");
    }
    pause();
    return nullptr;
}

int main() {
    alarm(20);
    pthread_t thread;
    if (pthread_create(&thread, nullptr, fill, nullptr) != 0) return 1;
    pthread_exit(nullptr);
}
