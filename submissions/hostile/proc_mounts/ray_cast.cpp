// Tries: to find a place to write among the mounts of /proc/self/mountinfo. Outcome: graded.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>

int main() {
    std::FILE* mounts = std::fopen("/proc/self/mountinfo", "r");
    char line[4096], point[2048];
    while (mounts != nullptr && std::fgets(line, sizeof line, mounts) != nullptr) {
        if (std::sscanf(line, "%*s %*s %*s %*s %2047s", point) != 1) continue;
        const std::string path = std::string(point) + "/raygrade-hostile-" + std::to_string(getpid());
        if (open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600) < 0) continue;
        std::printf("ESCAPED: made %s\n", path.c_str());
        unlink(path.c_str());
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
