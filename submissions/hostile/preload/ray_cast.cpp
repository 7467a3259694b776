// Tries: to shake off what it is held to by running itself again with LD_PRELOAD, through the loader. Outcome: graded.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

void look_around() {
    rlimit files{}, core{};
    getrlimit(RLIMIT_NOFILE, &files);
    getrlimit(RLIMIT_CORE, &core);
    const rlimit more = {files.rlim_max + 1, files.rlim_max + 1};
    if (files.rlim_max > 4096) std::puts("ESCAPED: as many files as it likes");
    if (setrlimit(RLIMIT_NOFILE, &more) == 0) std::puts("ESCAPED: a hard limit could be raised");
    if (core.rlim_max > 1) std::puts("ESCAPED: it may leave a core");
    if (std::fopen("/tmp/raygrade-decoy/answer_key.json", "r") != nullptr) std::puts("ESCAPED: the key can be opened");
}

int main(int argc, char** argv) {
    look_around();
    if (argc < 3) {
        std::fflush(stdout);
        setenv("LD_PRELOAD", "libm.so.6", 1);
        char own[4096] = {};
        if (readlink("/proc/self/exe", own, sizeof own - 1) < 0) std::strcpy(own, argv[0]);
        if (argc == 1) execl(own, own, "again", nullptr);
        execl("/lib64/ld-linux-x86-64.so.2", "ld.so", "--preload", "libm.so.6", own, "and", "again", nullptr);
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
