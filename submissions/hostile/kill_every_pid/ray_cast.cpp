// Tries: to kill every process from 2 to 32768 one by one. Outcome: graded.
#include <signal.h>
#include <unistd.h>

#include <cstdio>

int main() {
    int reachable = 0;
    for (pid_t pid = 2; pid <= 32768; ++pid) {
        if (pid == getpid() || kill(pid, 0) != 0) continue;
        ++reachable;
        if (pid == getppid()) kill(pid, SIGKILL);  // the others are spared: to be able to is enough
    }
    usleep(50000);
    if (reachable > 0) std::printf("ESCAPED: signals reach %d processes\n", reachable);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
