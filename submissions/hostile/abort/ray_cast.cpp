// Tries: to abort after its first answer. Outcome: crashed.
#include <cstdio>
#include <cstdlib>

int main() {
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
    std::fflush(stdout);
    std::abort();
}
