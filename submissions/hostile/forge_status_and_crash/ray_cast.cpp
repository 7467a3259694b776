// Tries: to say on every descriptor and on stdout that it ended well, and then crashes. Outcome: crashed.
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

int main() {
    signal(SIGPIPE, SIG_IGN);
    const char* forms[] = {"how=exited number=0 cpu-us=1 wall-us=1 peak-bytes=1 out-of-memory=0 step=\n",
                           "{\"how\":\"exited\",\"number\":0,\"cpu_us\":1,\"wall_us\":1,\"peak_bytes\":1}\n",
                           "{ \"exit-code\": 0 }\n"};
    for (const char* form : forms) {
        std::fputs(form, stdout);
        for (int fd = 3; fd <= 255; ++fd) {
            if (dprintf(fd, "%s", form) > 0) std::printf("ESCAPED: descriptor %d was open\n", fd);
        }
    }
    std::fflush(stdout);
    std::abort();
}
