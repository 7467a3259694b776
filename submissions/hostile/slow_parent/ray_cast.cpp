// Tries: to make the supervisor run last, so that it notices limits late. Outcome: graded.
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const id_t parent = static_cast<id_t>(getppid());
    if (setpriority(PRIO_PROCESS, parent, 19) == 0) std::puts("ESCAPED: setpriority worked on the parent");
    const sched_param lowest{};
    if (sched_setscheduler(getppid(), SCHED_IDLE, &lowest) == 0) std::puts("ESCAPED: the parent is SCHED_IDLE");
    cpu_set_t first;
    CPU_ZERO(&first);
    CPU_SET(0, &first);
    if (sched_setaffinity(getppid(), sizeof first, &first) == 0)
        std::puts("ESCAPED: the parent is bound to one processor");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
