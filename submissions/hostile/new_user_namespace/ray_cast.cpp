// Tries: to become root in a user namespace of its own. Outcome: graded.
#include <sched.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const long child = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, nullptr);
    if (child == 0) _exit(0);
    if (child > 0) std::puts("ESCAPED: clone(CLONE_NEWUSER) worked");
    if (unshare(CLONE_NEWUSER) == 0) std::puts("ESCAPED: unshare(CLONE_NEWUSER) worked");
    if (unshare(CLONE_NEWNS) == 0) std::puts("ESCAPED: unshare(CLONE_NEWNS) worked");
    while (wait(nullptr) > 0) {
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
