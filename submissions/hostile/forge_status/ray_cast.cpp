// Tries: to write the supervisor's status line on every descriptor it may have inherited. Outcome: graded.
#include <signal.h>
#include <unistd.h>

#include <cstdio>

int main() {
    signal(SIGPIPE, SIG_IGN);
    const char line[] = "how=exited number=0 cpu-us=1 wall-us=1 peak-bytes=1 out-of-memory=0 step=\n";
    for (int fd = 3; fd < 4096; ++fd) {
        if (write(fd, line, sizeof line - 1) > 0) std::printf("ESCAPED: wrote a status line to descriptor %d\n", fd);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
