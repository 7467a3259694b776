// Tries: to slow down everything its account runs, the harness among it, by PRIO_USER. Outcome: graded.
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

int main() {
    // To what it is, so that nothing changes: being allowed to is enough. Root's processes differ in theirs.
    if (geteuid() != 0 && (setpriority(PRIO_USER, 0, getpriority(PRIO_USER, 0)) == 0 || errno != EPERM)) {
        std::puts("ESCAPED: setpriority(PRIO_USER) is allowed");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
