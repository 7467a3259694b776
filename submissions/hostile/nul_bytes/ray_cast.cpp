// Tries: to end the reader's text early by NUL bytes. Outcome: graded.
#include <cstdio>

int main() {
    const char text[] = "Question 1\n\0\0\0P_VCS = (0.00,\0 9.00, -2.00)\nQuestion 2\nX_vcs = (1\0, 0, 7)\n";
    std::fwrite(text, 1, sizeof text, stdout);
}
