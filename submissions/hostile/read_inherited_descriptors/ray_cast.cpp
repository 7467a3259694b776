// Tries: to read whatever descriptors the harness left open. Outcome: graded.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

int main() {
    for (int fd = 3; fd < 4096; ++fd) {
        if (fcntl(fd, F_GETFD) < 0) continue;
        char text[64] = {};
        std::printf("ESCAPED: descriptor %d is open\n", fd);
        fcntl(fd, F_SETFL, O_NONBLOCK);
        if (pread(fd, text, sizeof text - 1, 0) > 0) std::printf("ESCAPED: it holds %s\n", text);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
