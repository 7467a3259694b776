// Tries: to leave the supervisor without descriptors by prlimit. Outcome: graded.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const rlimit none = {0, 0};
    if (prlimit(getppid(), RLIMIT_NOFILE, &none, nullptr) == 0)
        std::puts("ESCAPED: the parent may open no file any more");
    rlimit seen{};
    if (prlimit(getppid(), RLIMIT_NOFILE, nullptr, &seen) == 0) std::puts("ESCAPED: the parent's limits can be read");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
