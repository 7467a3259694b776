// Tries: to read the answer key, the grade book and another submission by their paths. Outcome: graded.
#include <cstdio>
#include <initializer_list>

int main() {
    char line[256];
    for (const char* path : {"/tmp/raygrade-decoy/answer_key.json", "/tmp/raygrade-decoy/gradebook.csv",
                             "/tmp/raygrade-decoy/other/ray_cast.cpp"}) {
        std::FILE* file = std::fopen(path, "r");
        if (file == nullptr) continue;
        if (std::fgets(line, sizeof line, file) != nullptr) std::printf("ESCAPED: %s begins %s\n", path, line);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
