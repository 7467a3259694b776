// Tries: to kill everything by kill(-1). Outcome: graded.
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

/// Processes that signals reach, apart from this one and the supervisor. All are seen only where numbers are short.
int count_reachable(int* largest) {
    *largest = 0;
    if (std::FILE* file = std::fopen("/proc/sys/kernel/pid_max", "r")) {
        if (std::fscanf(file, "%d", largest) != 1) *largest = 0;
    }
    int reachable = 0;
    for (pid_t pid = 1; pid <= 65536; ++pid) {
        if (pid != getpid() && pid != getppid() && kill(pid, 0) == 0) ++reachable;
    }
    return reachable;
}

int main() {
    int largest = 0;
    const int reachable = count_reachable(&largest);
    if (reachable > 0) std::printf("ESCAPED: kill(-1) would reach %d processes\n", reachable);
    std::fflush(stdout);
    const bool alone = kill(-1, 0) != 0 && errno == ESRCH;
    const bool all_seen = largest > 0 && largest <= 65536;
    // Nobody's machine is to suffer where nothing holds it back.
    if (alone || (reachable == 0 && all_seen)) kill(-1, SIGKILL);
    usleep(50000);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
