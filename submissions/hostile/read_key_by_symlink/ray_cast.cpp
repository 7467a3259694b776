// Tries: to read the answer key by a symbolic link, a hard link and the ways around of /proc. Outcome: graded.
#include <unistd.h>

#include <cstdio>
#include <string>

int main() {
    const char* key = "/tmp/raygrade-decoy/answer_key.json";
    const std::string mine = "raygrade-link-" + std::to_string(getpid());
    const std::string below_tmp = "/tmp/" + mine;
    if (symlink(key, mine.c_str()) != 0) std::perror("symlink");
    if (symlink(key, below_tmp.c_str()) != 0 && link(key, below_tmp.c_str()) != 0) std::perror("link");
    const std::string detours[] = {mine,
                                   below_tmp,
                                   std::string("/proc/self/root") + key,
                                   std::string("/proc/self/cwd/../../../..") + key,
                                   std::string("../../../..") + key,
                                   std::string("/usr/..") + key,
                                   std::string("/proc/self/task/../root") + key};
    for (const std::string& path : detours) {
        char line[256];
        std::FILE* file = std::fopen(path.c_str(), "r");
        if (file == nullptr) continue;
        if (std::fgets(line, sizeof line, file) != nullptr) std::printf("ESCAPED: %s begins %s\n", path.c_str(), line);
    }
    unlink(mine.c_str());
    unlink(below_tmp.c_str());
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
