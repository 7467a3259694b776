// Tries: to read stdin to its end, which never comes at a terminal or an open pipe. Outcome: graded.
#include <unistd.h>

#include <cstdio>

int main() {
    alarm(20);
    long bytes = 0;
    while (std::getchar() != EOF) ++bytes;
    if (bytes > 0) std::printf("ESCAPED: read %ld bytes of stdin\n", bytes);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
