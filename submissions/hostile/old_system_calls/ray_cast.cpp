// Tries: to reach forbidden calls by their 32-bit and x32 numbers. Outcome: graded.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

int main() {
#ifdef __x86_64__
    // In children: a filter may answer a call of another architecture by ending whoever made it.
    if (fork() == 0) {
        long result = 359;  // socket, for 32-bit programs
        asm volatile("int $0x80" : "+a"(result) : "b"(2), "c"(1), "d"(0) : "memory", "r8", "r9", "r10", "r11");
        _exit(result >= 0 ? 41 : 0);
    }
    if (fork() == 0) _exit(syscall(0x40000000 + 41, 2, 1, 0) >= 0 ? 42 : 0);
    int status = 0;
    while (wait(&status) > 0) {
        if (WIFEXITED(status) && WEXITSTATUS(status) > 40) std::puts("ESCAPED: there is a socket by another number");
    }
#endif
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
