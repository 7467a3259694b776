// Tries: to write to stderr without end. Outcome: timed_out.
#include <time.h>
#include <unistd.h>

#include <cstring>

int main() {
    const time_t end = time(nullptr) + 20;
    char line[4096];
    std::memset(line, 'x', sizeof line);
    while (time(nullptr) < end) {
        if (write(STDERR_FILENO, line, sizeof line) < 0) return 1;
    }
}
