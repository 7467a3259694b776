// Tries: to write into other submissions, the answer key and the grade book. Outcome: graded.
#include <fcntl.h>
#include <glob.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

/// Everything of a grading under way, other than this program's own.
std::vector<std::string> targets() {
    std::vector<std::string> paths = {"/tmp/raygrade-decoy/answer_key.json", "/tmp/raygrade-decoy/gradebook.csv"};
    struct stat own {
    }, info{};
    stat("ray_cast.cpp", &own);
    for (const char* pattern : {"/tmp/raygrade-*/*/ray_cast*", "../*/ray_cast*", "../shim", "../../raygrade-*/*/*"}) {
        glob_t found{};
        glob(pattern, 0, nullptr, &found);
        for (std::size_t i = 0; i < found.gl_pathc; ++i) {
            if (stat(found.gl_pathv[i], &info) == 0 && info.st_ino != own.st_ino) paths.push_back(found.gl_pathv[i]);
        }
    }
    return paths;
}

int main() {
    for (const std::string& path : targets()) {
        const int file = open(path.c_str(), O_WRONLY | O_APPEND);
        if (file < 0) continue;
        std::printf("ESCAPED: opened %s for writing\n", path.c_str());
        close(file);
    }
    if (open("ray_cast.cpp", O_WRONLY | O_APPEND) >= 0) std::puts("ESCAPED: can write what is being graded");
    const int added = open("/tmp/raygrade-decoy/other/added.cpp", O_WRONLY | O_CREAT, 0644);
    if (added >= 0) std::puts("ESCAPED: put a file into another submission");
    unlink("/tmp/raygrade-decoy/other/added.cpp");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
