// Tries: to become root through setuid(0) and the machine's set-user-ID programs. Outcome: graded.
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <initializer_list>

int main() {
    if (geteuid() == 0 && chroot(".") == 0) std::puts("ESCAPED: it is root, and chroot works");
    if (geteuid() != 0 && setuid(0) == 0) std::puts("ESCAPED: setuid(0) worked");
    std::fflush(stdout);
    for (const char* program : {"/usr/bin/su", "/usr/bin/mount", "/usr/bin/newgrp"}) {
        if (fork() != 0) continue;
        for (int fd = 0; fd < 3; ++fd) close(fd);
        execl(program, program, "--version", nullptr);
        _exit(1);
    }
    while (wait(nullptr) > 0) {
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
