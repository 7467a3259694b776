// Tries: to stop itself and wait for somebody to continue it. Outcome: timed_out.
#include <signal.h>
#include <unistd.h>

int main() {
    const pid_t self = getpid();
    if (fork() == 0) {  // alone on a machine, it is ended by this one
        sleep(20);
        kill(self, SIGKILL);
        _exit(0);
    }
    raise(SIGSTOP);
}
