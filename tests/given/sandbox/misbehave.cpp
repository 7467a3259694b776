// A program that misbehaves as its first argument says, for the tests of run_process. Every mode ends by itself after
// some seconds, so that a failing test can't exhaust the machine.

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;
const auto deadline = Clock::now() + std::chrono::seconds(40);

bool time_left() {
    return Clock::now() < deadline;
}

void sleep_long() {
    while (time_left()) usleep(100000);
}

void spin() {
    while (time_left()) {
    }
}

void say(const char* text) {
    if (write(STDOUT_FILENO, text, std::strlen(text)) < 0) _exit(90);
}

void touch_memory(std::size_t mebibytes) {
    const std::size_t size = mebibytes << 20;
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) _exit(91);
    std::memset(memory, 1, size);
}

void in_children(int count, const std::function<void()>& what) {
    for (int i = 0; i < count; ++i) {
        if (fork() == 0) {
            what();
            _exit(0);
        }
    }
    while (wait(nullptr) > 0) {
    }
}

int ignore_signals_and_sleep() {
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_IGN);
    sleep_long();
    return 0;
}

/// Whether a further process may be started. The bound applies to the whole bomb: a bomb that nobody stops must not use
/// up the machine's process ids.
bool may_fork() {
    static const int tokens = [] {
        int ends[2];
        const std::string some(2500, 'x');
        const bool filled = pipe2(ends, O_CLOEXEC | O_NONBLOCK) == 0 && write(ends[1], some.data(), some.size()) > 0;
        return filled ? ends[0] : -1;
    }();
    char token = 0;
    return time_left() && read(tokens, &token, 1) == 1;
}

int fork_bomb() {
    while (may_fork()) fork();
    sleep_long();
    return 0;
}

int fork_bomb_in_sessions() {
    while (may_fork()) {
        if (fork() == 0) setsid();
    }
    sleep_long();
    return 0;
}

/// Leaves a daemon in its own session that holds stdout and stderr open.
int daemonise() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) ignore_signals_and_sleep();
        _exit(0);
    }
    say("done\n");
    return 0;
}

/// Each process lives only long enough to start the next one.
int replace_itself() {
    if (fork() == 0) {
        while (may_fork()) {
            if (fork() != 0) _exit(0);
            setsid();
        }
        _exit(0);
    }
    usleep(50000);
    return 0;
}

int write_for_ever(int fd) {
    const std::string line(4096, 'x');
    while (time_left() && write(fd, line.data(), line.size()) > 0) {
    }
    return 0;
}

int write_bytes(const char* count) {
    const std::string text(static_cast<std::size_t>(std::atoi(count)), 'y');
    return write(STDOUT_FILENO, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
}

int write_big_file() {
    const int file = open("big", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    return write_for_ever(file);
}

int read_stdin() {
    char byte = 0;
    return read(STDIN_FILENO, &byte, 1) == 0 ? 0 : 1;
}

/// All of its stdin, up to a kilobyte.
std::string stdin_text() {
    char text[1024];
    std::size_t size = 0;
    for (ssize_t more = 1; more > 0; size += static_cast<std::size_t>(std::max<ssize_t>(more, 0)))
        more = read(STDIN_FILENO, text + size, sizeof text - size);
    return {text, size};
}

int close_outputs() {
    say("before");
    close(STDOUT_FILENO);
    close(STDERR_FILENO);
    usleep(100000);
    return 5;
}

int list_descriptors() {
    for (int fd = 0; fd < 4096; ++fd) {
        if (fcntl(fd, F_GETFD) >= 0) std::printf("%d ", fd);
    }
    return 0;
}

/// Tries to report a status before the supervisor does.
int forge_status() {
    const char line[] = "how=exited number=0 cpu-us=1 wall-us=1 peak-bytes=1 out-of-memory=0 step=\n";
    for (int fd = 3; fd < 4096; ++fd) {
        if (write(fd, line, sizeof line - 1) > 0) return 92;
    }
    return 7;
}

int show_surroundings() {
    for (char** variable = environ; *variable != nullptr; ++variable) std::printf("%s\n", *variable);
    char folder[4096];
    std::printf("%s\n", getcwd(folder, sizeof folder));
    return 0;
}

int leave_children(int count) {
    for (int i = 0; i < count; ++i) {
        if (fork() == 0) {
            sleep_long();
            _exit(0);
        }
    }
    _exit(0);
}

/// Returns 0 if no signal is blocked or ignored.
int check_signals() {
    sigset_t blocked;
    sigprocmask(SIG_SETMASK, nullptr, &blocked);
    for (int number = 1; number < 32; ++number) {
        struct sigaction action {};
        sigaction(number, nullptr, &action);
        if (sigismember(&blocked, number) == 1 || action.sa_handler == SIG_IGN) return number;
    }
    return 0;
}

int both_outputs() {
    say("out");
    return write(STDERR_FILENO, "err", 3) == 3 ? 0 : 1;
}

int orphan_that_spins() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) spin();
        _exit(0);
    }
    sleep_long();
    return 0;
}

int raise_and_sleep(pid_t whom, int number) {
    kill(whom, number);
    sleep_long();
    return 0;
}

/// The second process would survive if the supervisor were merely killed.
int stop_supervisor() {
    const pid_t supervisor = getppid();
    if (fork() == 0) {
        setsid();
        sleep_long();
        _exit(0);
    }
    return raise_and_sleep(supervisor, SIGSTOP);
}

}  // namespace

int main(int argc, char** argv) {
    std::string mode = argc > 1 ? argv[1] : "";
    std::string stated = argc > 2 ? argv[2] : "0";
    if (mode == "as-told") {
        mode = stdin_text();
        const std::size_t blank = std::min(mode.find(' '), mode.size());
        stated = mode.substr(std::min(blank + 1, mode.size()));
        mode.resize(blank);
    }
    const char* const value = stated.c_str();
    const std::map<std::string, std::function<int()>> modes = {
        {"exit", [&] { return std::atoi(value); }},
        {"spin", [] { return spin(), 0; }},
        {"ignore-signals", ignore_signals_and_sleep},
        {"fork-bomb", fork_bomb},
        {"fork-bomb-in-sessions", fork_bomb_in_sessions},
        {"daemonise", daemonise},
        {"leave-children", [&] { return leave_children(std::atoi(value)); }},
        {"replace-itself", replace_itself},
        {"touch-memory", [&] { return touch_memory(static_cast<std::size_t>(std::atoi(value))), 0; }},
        {"children-with-memory", [] { return in_children(8, [] { touch_memory(40), sleep_long(); }), 0; }},
        {"spinning-children", [] { return in_children(4, spin), 0; }},
        {"orphan-that-spins", orphan_that_spins},
        {"endless-output", [] { return write_for_ever(STDOUT_FILENO); }},
        {"endless-errors", [] { return write_for_ever(STDERR_FILENO); }},
        {"write-bytes", [&] { return write_bytes(value); }},
        {"big-file", write_big_file},
        {"read-stdin", read_stdin},
        {"say", [&] { return say(value), 0; }},
        {"close-outputs", close_outputs},
        {"list-descriptors", list_descriptors},
        {"forge-status", forge_status},
        {"surroundings", show_surroundings},
        {"signals", check_signals},
        {"both-outputs", both_outputs},
        {"segv", [] { return raise(SIGSEGV); }},
        {"abort", []() -> int { std::abort(); }},
        {"kill-supervisor", [] { return raise_and_sleep(getppid(), SIGKILL); }},
        {"stop-supervisor", stop_supervisor},
    };
    const auto found = modes.find(mode);
    return found == modes.end() ? 93 : found->second();
}
