#include "harness/sandbox/supervisor/program.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "harness/machine/file_descriptor.h"
#include "harness/sandbox/supervisor/landlock.h"
#include "harness/sandbox/supervisor/system_calls.h"

namespace harness {
namespace {

/// The child writes this to the pipe if a step fails. A successful exec closes the pipe without a message, so a program
/// that exits with 127 never looks like a program that did not run.
struct Failure {
    int error = 0;
    std::array<char, 32> step{};
};

[[noreturn]] void give_up(int report_fd, const char* step) {
    Failure failure;
    failure.error = errno;
    std::strncpy(failure.step.data(), step, failure.step.size() - 1);
    [[maybe_unused]] const ssize_t written = write(report_fd, &failure, sizeof failure);
    _exit(127);
}

/// Sets a limit, but never above the machine's own hard limit.
bool limit(__rlimit_resource_t resource, std::uint64_t value) {
    rlimit current{};
    if (getrlimit(resource, &current) != 0) return false;
    const auto wanted = std::min(static_cast<rlim_t>(value), current.rlim_max);
    const rlimit lowered = {wanted, wanted};
    return setrlimit(resource, &lowered) == 0;
}

/// The number of tasks on the whole machine, an upper bound for this user's tasks.
std::uint64_t tasks_on_this_machine() {
    std::ifstream file("/proc/loadavg");
    std::string word;
    for (int i = 0; i < 4; ++i) file >> word;
    const std::size_t slash = word.find('/');
    return slash == std::string::npos ? 0 : std::strtoull(word.c_str() + slash + 1, nullptr, 10);
}

/// The number of tasks that the program's account may have. If the account has no other tasks, the kernel counts this
/// tree exactly; there is room for the supervisor and for exceeding the limit, so that the supervisor sees a fork bomb.
/// Otherwise the limit only keeps a fork bomb from filling the machine.
std::uint64_t task_limit(const SupervisorOrders& orders) {
    constexpr std::uint64_t room = 16;
    constexpr std::uint64_t tasks_for_parallel_runs = 512;
    if (orders.counted_alone) return static_cast<std::uint64_t>(orders.limits.processes) + room;
    return tasks_on_this_machine() + tasks_for_parallel_runs;
}

/// Sets the kernel's limits, which stop a program between two checks of the supervisor. RLIMIT_CPU is therefore above
/// the supervisor's limit.
void set_limits(const SupervisorOrders& orders, int report_fd) {
    const Limits& limits = orders.limits;
    constexpr std::uint64_t signals_waiting = 256;
    const auto cpu_seconds = static_cast<std::uint64_t>(limits.cpu.count()) / 1000 + 3;
    if (!limit(RLIMIT_CPU, cpu_seconds)) give_up(report_fd, "setrlimit-cpu");
    if (!limit(RLIMIT_FSIZE, limits.file_bytes)) give_up(report_fd, "setrlimit-file-size");
    if (!limit(RLIMIT_STACK, limits.stack_bytes)) give_up(report_fd, "setrlimit-stack");
    // Not 0: the kernel would then still start the machine's program that receives core dumps through a pipe, see
    // core(5).
    if (!limit(RLIMIT_CORE, 1)) give_up(report_fd, "setrlimit-core");
    if (!limit(RLIMIT_SIGPENDING, signals_waiting)) give_up(report_fd, "setrlimit-signals");
    if (!limit(RLIMIT_NOFILE, static_cast<std::uint64_t>(limits.open_files)))
        give_up(report_fd, "setrlimit-open-files");
    if (!limit(RLIMIT_NPROC, task_limit(orders))) give_up(report_fd, "setrlimit-processes");
}

/// Applies the tier's restrictions to this process. The kernel enforces them, whatever the program does.
void confine(const SupervisorOrders& orders, int report_fd) {
    if (orders.account && !become(*orders.account)) give_up(report_fd, "account");
    if (orders.tier == Tier::unsafe) return;
    ForbiddenCalls more;
    const bool compiles = orders.purpose == Purpose::compile;
    more.uncounted_use = !compiles;
    if (orders.tier == Tier::landlock) {
        constexpr int since_signals = 6;
        std::vector<std::string> readable = orders.readable;
        std::vector<std::string> writable = {"/dev/null"};
        (compiles ? writable : readable).push_back(orders.working_directory);
        if (!restrict_files(readable, writable)) give_up(report_fd, "landlock");
        // A program with its own account cannot signal other processes.
        more.signals = landlock_version() < since_signals && !orders.account;
        // The linker needs these calls to make its output executable, and no source can make the compiler change other
        // files.
        more.file_attributes = !compiles;
    }
    if (!forbid_system_calls(more)) give_up(report_fd, "seccomp");
}

/// Restores the signal handling of a program that was started from a shell.
void restore_signals() {
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_program(const SupervisorOrders& orders, pid_t supervisor, int report_fd) {
    if (setsid() < 0) give_up(report_fd, "setsid");
    restore_signals();
    set_limits(orders, report_fd);
    if (chdir(orders.working_directory.c_str()) != 0) give_up(report_fd, "chdir");
    confine(orders, report_fd);
    // If the supervisor is killed, the kernel kills at least the first process. The kernel forgets this setting when
    // the account changes, so it comes after confine. The parent may be gone already, so check for it afterwards.
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) give_up(report_fd, "pdeathsig");
    if (getppid() != supervisor) _exit(127);
    if (close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) != 0) give_up(report_fd, "close_range");
    std::vector<char*> argv;
    for (const auto& argument : orders.argv) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    give_up(report_fd, "exec");
}

}  // namespace

StartedProgram start_program(const SupervisorOrders& orders) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {-1, errno, "pipe"};
    const FileDescriptor read_end(ends[0]);
    FileDescriptor write_end(ends[1]);
    const pid_t supervisor = getpid();
    const pid_t pid = fork();
    if (pid < 0) return {-1, errno, "fork"};
    if (pid == 0) become_program(orders, supervisor, write_end.get());
    write_end.close();
    Failure failure;
    ssize_t size = 0;
    while ((size = read(read_end.get(), &failure, sizeof failure)) < 0 && errno == EINTR) {
    }
    if (size == 0) return {pid, 0, {}};
    waitpid(pid, nullptr, 0);
    return {-1, failure.error, failure.step.data()};
}

}  // namespace harness
