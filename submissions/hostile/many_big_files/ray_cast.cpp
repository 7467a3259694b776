// Tries: many files that are each just below the limit of one. Outcome: graded.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
    static char zeros[15 << 20];
    const char* home = std::getenv("HOME");
    const char* temporary = std::getenv("TMPDIR");
    int written = 0;
    for (const char* folder : {".", home, temporary, "/tmp", "/var/tmp", "/dev/shm", "/run", "/dev"}) {
        if (folder == nullptr) continue;
        for (int i = 0; i < 4; ++i) {  // four show as well as a thousand that nothing stops it
            const std::string path =
                std::string(folder) + "/raygrade-many-" + std::to_string(getpid()) + '-' + std::to_string(i);
            const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
            if (file < 0) continue;
            if (write(file, zeros, sizeof zeros) > 0) ++written;
            close(file);
            unlink(path.c_str());
        }
    }
    if (written > 0) std::printf("ESCAPED: wrote %d files of 15 MiB\n", written);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
