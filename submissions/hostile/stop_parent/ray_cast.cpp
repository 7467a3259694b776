// Tries: to stop the supervisor, so that no limit is kept, and to run on. Outcome: graded.
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <string>

int main() {
    const pid_t parent = getppid();
    kill(parent, SIGSTOP);
    usleep(100000);
    char state = '?';
    if (std::FILE* file = std::fopen(("/proc/" + std::to_string(parent) + "/stat").c_str(), "r")) {
        if (std::fscanf(file, "%*d (%*[^)]) %c", &state) != 1) state = '?';
    }
    if (state == 'T') std::puts("ESCAPED: the supervisor is stopped");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
