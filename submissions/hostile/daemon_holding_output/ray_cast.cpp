// Tries: to leave a daemon that holds stdout open. Outcome: graded.
#include <signal.h>
#include <unistd.h>

#include <cstdio>

int main() {
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
    std::fflush(stdout);
    if (fork() == 0) {
        setsid();
        if (fork() != 0) _exit(0);
        signal(SIGTERM, SIG_IGN);
        signal(SIGHUP, SIG_IGN);
        alarm(30);
        pause();
    }
}
