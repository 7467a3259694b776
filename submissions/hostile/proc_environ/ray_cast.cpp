// Tries: to find the harness's environment in that of every process. Outcome: graded.
#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

int main() {
    static char text[1 << 17];
    DIR* processes = opendir("/proc");
    while (const dirent* process = processes == nullptr ? nullptr : readdir(processes)) {
        if (std::atoi(process->d_name) <= 0) continue;
        const int file = open((std::string("/proc/") + process->d_name + "/environ").c_str(), O_RDONLY);
        if (file < 0) continue;
        const ssize_t size = read(file, text, sizeof text - 1);
        close(file);
        const void* at = size <= 0 ? nullptr : memmem(text, static_cast<std::size_t>(size), "RAYGRADE_DECOY=", 15);
        if (at != nullptr) std::printf("ESCAPED: process %s has %s\n", process->d_name, static_cast<const char*>(at));
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
