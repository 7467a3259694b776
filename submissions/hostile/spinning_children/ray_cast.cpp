// Tries: to compute in four processes, each below the time limit for longer than one would be. Outcome: timed_out.
#include <sys/wait.h>
#include <unistd.h>

int main() {
    for (int i = 0; i < 4; ++i) {
        if (fork() != 0) continue;
        alarm(20);
        for (volatile unsigned spin = 0;; spin = spin + 1) {
        }
    }
    while (wait(nullptr) > 0) {
    }
}
