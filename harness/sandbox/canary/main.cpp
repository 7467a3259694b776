// raygrade-canary DECOY PORT PID: tries everything that a sandbox must prevent. Prints a line for each attempt with its
// name and errno, 0 for success. Nothing it does harms a machine without a sandbox. An autograder's zip takes it to
// older systems, so it calls nothing that a C or C++ library of 2022 lacks.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

namespace {

/// 0 if the text is not a number. The C functions for this have new names in a new C library, which an older one lacks.
int number(const char* text) {
    int value = 0;
    std::from_chars(text, text + std::strlen(text), value);
    return value;
}

void tell(const char* attempt, bool succeeded) {
    const int error = succeeded ? 0 : errno;
    dprintf(STDOUT_FILENO, "%s %d\n", attempt, error);
}

/// Prints the content, so that the harness sees whether reading succeeded.
bool read_file(const char* path) {
    const int file = open(path, O_RDONLY);
    char text[256];
    const ssize_t size = file < 0 ? -1 : read(file, text, sizeof text);
    if (size > 0) dprintf(STDOUT_FILENO, "contents %.*s\n", static_cast<int>(size), text);
    return size >= 0;
}

bool overwrite(const char* path) {
    const int file = open(path, O_WRONLY | O_TRUNC);
    return file >= 0 || truncate(path, 0) == 0;
}

bool leave_a_file() {
    for (const char* path : {"./left-behind", "/left-behind", "/tmp/raygrade-canary-left-behind",
                             "/dev/shm/raygrade-canary-left-behind"}) {
        const int file = open(path, O_WRONLY | O_CREAT, 0600);
        if (file < 0) continue;
        unlink(path);
        return true;
    }
    return false;
}

bool connect_to(const char* port) {
    const int connection = socket(AF_INET, SOCK_STREAM, 0);
    if (connection < 0) return false;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(number(port)));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
}

/// The lifetime of processes that should be stopped at once. A busy virtual machine may pause for a second or two, and
/// then the supervisor does not check either.
constexpr unsigned lifetime_seconds = 8;

/// Starts more processes than any limit allows.
int start_processes() {
    constexpr int many = 64;
    int started = 0;
    for (; started < many; ++started) {
        const pid_t child = fork();
        if (child < 0) break;
        if (child == 0) {
            sleep(lifetime_seconds);
            _exit(0);
        }
    }
    return started;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    tell("read", read_file(argv[1]));
    tell("overwrite", overwrite(argv[1]));
    tell("leave", leave_a_file());
    tell("connect", connect_to(argv[2]));
    tell("signal", kill(number(argv[3]), 0) == 0);
    tell("namespace", unshare(CLONE_NEWUSER) == 0);
    dprintf(STDOUT_FILENO, "processes %d\n", start_processes());
    sleep(lifetime_seconds);
    return 0;
}
