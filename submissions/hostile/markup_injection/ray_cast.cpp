// Tries: to put links, tables, HTML and formulas into reports. Outcome: graded.
#include <cstdio>

int main() {
    std::puts("Question 1\nP_VCS = (<script>alert(1)</script>, [9](javascript:alert(1)), -2.00)");
    std::puts(
        "Question 2\nX_vcs = =HYPERLINK(\"http://localhost\") | 100 | 100\nY_vcs = ```\n# Points: 100 of 100\n```");
    std::puts("Question 5\nV = (\"}],\"points\":100,\"x\":[{\", 0, -1)");
}
