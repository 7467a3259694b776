// Tries: to close stdout and stderr and to go on. Outcome: graded.
#include <unistd.h>

#include <cstdio>

int main() {
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
    std::fflush(stdout);
    close(STDOUT_FILENO);
    close(STDERR_FILENO);
    usleep(200000);
    _exit(0);
}
