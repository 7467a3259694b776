// Tries: to ask by __has_include whether the answer key and other files are there. Outcome: graded or compile_error.
#include <cstdio>

int main() {
#if __has_include("/tmp/raygrade-decoy/answer_key.json")
    std::puts("ESCAPED: the answer key is there");
#endif
#if __has_include("/tmp/raygrade-decoy/other/ray_cast.cpp")
    std::puts("ESCAPED: the other submission is there");
#endif
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
