// Tries: 60,000 empty files. Outcome: graded.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
    const char* home = std::getenv("HOME");
    const char* temporary = std::getenv("TMPDIR");
    for (const char* folder : {".", home, temporary, "/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue"}) {
        if (folder == nullptr) continue;
        const std::string start = std::string(folder) + "/raygrade-empty-" + std::to_string(getpid()) + '-';
        int made = 0;
        while (made < 200) {  // as many show as well as 60,000 that nothing stops it
            const int file = open((start + std::to_string(made)).c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
            if (file < 0) break;
            close(file);
            ++made;
        }
        for (int i = 0; i < made; ++i) unlink((start + std::to_string(i)).c_str());
        if (made > 0) std::printf("ESCAPED: made %d files in %s\n", made, folder);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
