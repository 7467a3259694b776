// Tries: to write to a null pointer after its first answer. Outcome: crashed.
#include <cstdio>

int main() {
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
    std::fflush(stdout);
    volatile int* volatile nowhere = nullptr;
    *nowhere = 1;
}
