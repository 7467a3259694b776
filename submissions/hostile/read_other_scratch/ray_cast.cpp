// Tries: to read what other submissions being graded have in their folders. Outcome: graded.
#include <glob.h>
#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
    struct stat own {
    }, info{};
    stat("ray_cast.cpp", &own);
    const char* temporary = std::getenv("TMPDIR");
    for (const char* folder : {"/tmp", "/var/tmp", "..", "../..", temporary}) {
        if (folder == nullptr) continue;
        for (const char* below : {"/*/ray_cast.cpp", "/raygrade-*/*/ray_cast.cpp"}) {
            glob_t found{};
            glob((std::string(folder) + below).c_str(), 0, nullptr, &found);
            for (std::size_t i = 0; i < found.gl_pathc; ++i) {
                const char* other = found.gl_pathv[i];
                if (stat(other, &info) != 0 || info.st_ino == own.st_ino) continue;
                if (std::fopen(other, "r") != nullptr) std::printf("ESCAPED: can read %s\n", other);
            }
        }
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
