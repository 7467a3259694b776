// Tries: 400 threads at one time; a refused thread aborts it. Outcome: crashed.
#include <pthread.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

void* wait_long(void*) {
    sleep(4);
    return nullptr;
}

int main() {
    alarm(8);
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 64 * 1024);
    for (int i = 0; i < 400; ++i) {
        pthread_t thread;
        if (pthread_create(&thread, &small, wait_long, nullptr) != 0) std::abort();
    }
    sleep(4);
    std::puts("ESCAPED: 400 threads lived at one time");
}
