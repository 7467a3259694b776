// Tries: to wait for a child of vfork that never leaves its parent's memory. Outcome: timed_out.
#include <unistd.h>

int main() {
    if (vfork() == 0) {
        alarm(20);
        pause();
        _exit(0);
    }
}
