// Tries: to take control of the supervisor by ptrace. Outcome: graded.
#include <sys/ptrace.h>
#include <unistd.h>

#include <cstdio>

int main() {
    if (ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr) == 0) std::puts("ESCAPED: PTRACE_SEIZE of the parent worked");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
