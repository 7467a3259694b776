// Tries: 24 threads in a process whose first thread has ended, which /proc shows as a zombie. Outcome: crashed.
#include <pthread.h>
#include <unistd.h>

#include <cstdlib>

void* wait_long(void*) {
    pause();
    return nullptr;
}

int main() {
    alarm(20);
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 64 * 1024);
    pthread_t thread;
    for (int i = 0; i < 12; ++i) {
        if (pthread_create(&thread, &small, wait_long, nullptr) != 0) std::abort();
    }
    if (fork() != 0) pause();
    for (int i = 0; i < 12; ++i) {
        if (pthread_create(&thread, &small, wait_long, nullptr) != 0) std::abort();
    }
    pthread_exit(nullptr);
}
