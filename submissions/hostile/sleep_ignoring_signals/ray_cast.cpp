// Tries: to sleep on through TERM, INT, HUP, XCPU and every other signal that can be ignored. Outcome: timed_out.
#include <signal.h>
#include <time.h>
#include <unistd.h>

int main() {
    const time_t end = time(nullptr) + 20;
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_IGN);
    while (time(nullptr) < end) usleep(100000);
}
