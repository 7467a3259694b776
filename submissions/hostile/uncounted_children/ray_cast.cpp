// Tries: to compute in children that nobody waits for, so that their time is added to nobody's. Outcome: timed_out.
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>

void spin(double seconds) {
    timespec now{};
    do {
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    } while (static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) < seconds);
}

int main() {
    signal(SIGCHLD, SIG_IGN);
    for (int i = 0; i < 25; ++i) {  // 2.5 s in all
        const pid_t child = fork();
        if (child == 0) {
            spin(0.1);
            _exit(0);
        }
        while (child > 0 && kill(child, 0) == 0) usleep(1000);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
