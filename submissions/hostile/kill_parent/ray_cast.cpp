// Tries: to kill the supervisor. Outcome: graded.
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <initializer_list>

int main() {
    const pid_t parent = getppid();
    for (const int number : {SIGHUP, SIGINT, SIGTERM, SIGSEGV, SIGKILL}) {
        kill(parent, number);
        syscall(SYS_tgkill, parent, parent, number);
    }
    usleep(100000);
    if (getppid() != parent) std::puts("ESCAPED: the supervisor is gone");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
