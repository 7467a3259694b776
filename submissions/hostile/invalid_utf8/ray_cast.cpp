// Tries: to break reports by bytes that are not UTF-8, and by characters that turn the text around. Outcome: graded.
#include <cstdio>

int main() {
    std::puts("Question 1\nP_VCS = (0.00, \xff\xfe\x80 9.00, -2.00\xc0\xaf)");
    std::puts("Question 2\nX_vcs = \xed\xa0\x80(1, 0, 7)\xf4\x90\x80\x80\nY_vcs = \xe2\x80\xae(0, 1, 3)\xe2\x80");
    std::fputs("Question 5\nV = (0, 0, \xf0\x9f", stdout);
}
