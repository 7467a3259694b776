// Tries: an endless loop. Outcome: timed_out.
#include <unistd.h>

int main() {
    alarm(20);  // alone on a machine, it ends by itself
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}
