// Tries: to learn from their command lines what other processes work on. Outcome: graded.
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
        if (pid <= 0 || pid == getpid() || pid == getppid()) continue;
        const int file = open((std::string("/proc/") + process->d_name + "/cmdline").c_str(), O_RDONLY);
        char byte = 0;
        if (file >= 0 && read(file, &byte, 1) == 1) ++seen;
        if (file >= 0) close(file);
    }
    if (seen > 0) std::printf("ESCAPED: read the command lines of %d other processes\n", seen);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
