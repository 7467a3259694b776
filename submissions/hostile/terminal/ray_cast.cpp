// Tries: to type into the instructor's terminal by TIOCSTI. Outcome: graded.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <initializer_list>

int main() {
    for (const int fd : {open("/dev/tty", O_RDWR), 0, 1, 2}) {
        char key = '\0';
        if (fd >= 0 && ioctl(fd, TIOCSTI, &key) == 0) std::printf("ESCAPED: typed a key into descriptor %d\n", fd);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
