// Tries: to rewrite the instructor's terminal by escape sequences, also of 8 bits. Outcome: graded.
#include <cstdio>

int main() {
    std::puts("\x1b]0;owned\x07\x1b[2J\x1b[HQuestion 1\n\x1b[31mP_VCS = (0.00, 0.00, \x1b[8m-3.00\x1b[0m)");
    std::puts(
        "Question 2\nX_vcs = (1, 0, \x9b\x32Jx7)\rY_vcs = \x1b[1A100/100\b\b\b\nZ_vcs = \xc2\x9b\x33m(0, 0, 1)\x7f");
    std::puts("\x1b[5i\x1bP\x1b\\Question \x1b[1m5\x1b[0m\nV = (0, 0, -1\v)\f");
}
