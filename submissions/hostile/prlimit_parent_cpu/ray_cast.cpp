// Tries: to let the supervisor run out of processor time by prlimit. Outcome: graded.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const rlimit none = {0, 0};
    if (prlimit(getppid(), RLIMIT_CPU, &none, nullptr) == 0)
        std::puts("ESCAPED: the parent has no processor time left");
    usleep(100000);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
