// Tries: a file of 10 GB, in whatever folder takes one. Outcome: graded.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
    signal(SIGXFSZ, SIG_IGN);
    const char* home = std::getenv("HOME");
    const char* temporary = std::getenv("TMPDIR");
    static char zeros[1 << 20];
    for (const char* folder : {".", home, temporary, "/tmp", "/var/tmp", "/dev/shm", "/run", "/usr", "/"}) {
        if (folder == nullptr) continue;
        const std::string path = std::string(folder) + "/raygrade-big-" + std::to_string(getpid());
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
        if (file < 0) continue;
        int mebibytes = 0;
        // 10 GB would be 9537; 64 show as well that nothing stops it.
        while (mebibytes < 64 && write(file, zeros, sizeof zeros) == sizeof zeros) ++mebibytes;
        std::printf("ESCAPED: wrote %d MiB to %s\n", mebibytes, path.c_str());
        unlink(path.c_str());
        return 0;
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
