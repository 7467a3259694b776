// Tries: files in memory by memfd_create, which can be run and which no limit of the process counts. Outcome: graded.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>

int main() {
    static char zeros[1 << 20];
    const int file = memfd_create("raygrade-hostile", 0);
    if (file >= 0) {
        int mebibytes = 0;
        while (mebibytes < 15 && write(file, zeros, sizeof zeros) == sizeof zeros) ++mebibytes;
        std::printf("ESCAPED: memfd_create gave a file, %d MiB written\n", mebibytes);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
