// Tries: to type into a terminal by TIOCSTI, here into one of its own making. Outcome: graded.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <initializer_list>

int main() {
    std::fflush(stdout);
    if (fork() == 0) {
        setsid();  // so that the terminal becomes the one that controls it
        const int side = posix_openpt(O_RDWR | O_NOCTTY);
        const bool open_for_all = side >= 0 && grantpt(side) == 0 && unlockpt(side) == 0;
        const int terminal = open_for_all ? open(ptsname(side), O_RDWR) : -1;
        char key = 'x';
        for (const int fd : {terminal, open("/dev/tty", O_RDWR)}) {
            if (fd >= 0 && ioctl(fd, TIOCSTI, &key) == 0) _exit(41);
        }
        _exit(0);
    }
    int status = 0;
    wait(&status);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 41) std::puts("ESCAPED: typed a key");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
