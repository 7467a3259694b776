// Tries: to use other processes' descriptors through /proc/PID/fd. Outcome: graded.
#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
    DIR* processes = opendir("/proc");
    int seen = 0;
    while (const dirent* process = processes == nullptr ? nullptr : readdir(processes)) {
        const int pid = std::atoi(process->d_name);
        if (pid <= 0 || pid == getpid()) continue;
        for (int fd = 0; fd < 16; ++fd) {
            char target[256];
            const std::string path = "/proc/" + std::to_string(pid) + "/fd/" + std::to_string(fd);
            if (readlink(path.c_str(), target, sizeof target) > 0) ++seen;
            if (pid == getppid() && open(path.c_str(), O_RDWR) >= 0) std::printf("ESCAPED: opened %s\n", path.c_str());
        }
    }
    if (seen > 0) std::printf("ESCAPED: saw %d descriptors of other processes\n", seen);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
