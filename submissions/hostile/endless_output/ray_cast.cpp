// Tries: to print 10 GB. Outcome: output_limit.
#include <unistd.h>

#include <cstring>

int main() {
    alarm(20);
    char line[10000];
    std::memset(line, 'x', sizeof line);
    for (int i = 0; i < 1'000'000; ++i) {
        if (write(STDOUT_FILENO, line, sizeof line) < 0) return 1;
    }
}
