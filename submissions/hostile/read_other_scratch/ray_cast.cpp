// Tries: to read what other submissions being graded have in their folders. Outcome: graded.
#include <glob.h>
#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
    struct stat own {};
    stat(".", &own);
    const char* temporary = std::getenv("TMPDIR");
    for (const char* folder : {"/tmp", "/var/tmp", "..", temporary}) {
        if (folder == nullptr) continue;
        glob_t found{};
        glob((std::string(folder) + "/raygrade-??????").c_str(), 0, nullptr, &found);
        for (std::size_t i = 0; i < found.gl_pathc; ++i) {
            const std::string other = found.gl_pathv[i];
            struct stat info {};
            if (stat(other.c_str(), &info) != 0 || info.st_ino == own.st_ino) continue;
            if (std::FILE* file = std::fopen((other + "/ray_cast.cpp").c_str(), "r")) {
                std::printf("ESCAPED: read %s/ray_cast.cpp\n", other.c_str());
                std::fclose(file);
            }
        }
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
