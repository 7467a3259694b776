#include "harness/sandbox/shim_program.h"

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

#include "harness/sandbox/file_descriptor.h"
#include "harness/sandbox/landlock.h"
#include "harness/sandbox/system_calls.h"

namespace harness {
namespace {

/// What the child writes when a step fails. The pipe closes silently at a successful exec, so that a program that exits
/// with 127 is never mistaken for one that did not run.
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

/// The machine's own hard limit wins where it is lower.
bool limit(__rlimit_resource_t resource, std::uint64_t value) {
    rlimit current{};
    if (getrlimit(resource, &current) != 0) return false;
    const auto wanted = std::min(static_cast<rlim_t>(value), current.rlim_max);
    const rlimit lowered = {wanted, wanted};
    return setrlimit(resource, &lowered) == 0;
}

/// The tasks of the whole machine, an upper bound of those this user has.
std::uint64_t tasks_on_this_machine() {
    std::ifstream file("/proc/loadavg");
    std::string word;
    for (int i = 0; i < 4; ++i) file >> word;
    const std::size_t slash = word.find('/');
    return slash == std::string::npos ? 0 : std::strtoull(word.c_str() + slash + 1, nullptr, 10);
}

/// How many tasks the program's account may have. Where it has no others the kernel counts this tree, with room for the
/// shim and for the shim to see that a bomb is one; else a bomb can only be kept from filling the machine.
std::uint64_t task_limit(const ShimOrders& orders) {
    constexpr std::uint64_t room = 16;
    constexpr std::uint64_t tasks_for_parallel_runs = 512;
    if (orders.counted_alone) return static_cast<std::uint64_t>(orders.limits.processes) + room;
    return tasks_on_this_machine() + tasks_for_parallel_runs;
}

/// A net below the shim's own checks, for what can happen between two of them. RLIMIT_CPU is therefore above the shim's
/// limit.
void set_limits(const ShimOrders& orders, int report_fd) {
    const Limits& limits = orders.limits;
    constexpr std::uint64_t signals_waiting = 256;
    const auto cpu_seconds = static_cast<std::uint64_t>(limits.cpu.count()) / 1000 + 3;
    if (!limit(RLIMIT_CPU, cpu_seconds)) give_up(report_fd, "setrlimit-cpu");
    if (!limit(RLIMIT_FSIZE, limits.file_bytes)) give_up(report_fd, "setrlimit-file-size");
    if (!limit(RLIMIT_STACK, limits.stack_bytes)) give_up(report_fd, "setrlimit-stack");
    // Not 0: a program that takes the core through a pipe, as core(5) allows, would be started for that.
    if (!limit(RLIMIT_CORE, 1)) give_up(report_fd, "setrlimit-core");
    if (!limit(RLIMIT_SIGPENDING, signals_waiting)) give_up(report_fd, "setrlimit-signals");
    if (!limit(RLIMIT_NOFILE, static_cast<std::uint64_t>(limits.open_files)))
        give_up(report_fd, "setrlimit-open-files");
    if (!limit(RLIMIT_NPROC, task_limit(orders))) give_up(report_fd, "setrlimit-processes");
}

/// Takes from this process what the tier takes. The kernel's own means, so that nothing of it depends on the program.
void confine(const ShimOrders& orders, int report_fd) {
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
        // An account of its own has nobody else to signal.
        more.signals = landlock_version() < since_signals && !orders.account;
        // The linker makes its output executable, and nothing it reads can make a compiler change other files.
        more.file_attributes = !compiles;
    }
    if (!forbid_system_calls(more)) give_up(report_fd, "seccomp");
}

/// The program is to find signals as a shell would leave them, whatever the harness and the shim did to theirs.
void restore_signals() {
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_program(const ShimOrders& orders, pid_t shim, int report_fd) {
    if (setsid() < 0) give_up(report_fd, "setsid");
    restore_signals();
    set_limits(orders, report_fd);
    if (chdir(orders.working_directory.c_str()) != 0) give_up(report_fd, "chdir");
    confine(orders, report_fd);
    // A shim that is killed takes at least the first process with it. The kernel forgets this when the account changes;
    // asked for before the look at the parent, which may be gone already.
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) give_up(report_fd, "pdeathsig");
    if (getppid() != shim) _exit(127);
    if (close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) != 0) give_up(report_fd, "close_range");
    std::vector<char*> argv;
    for (const auto& argument : orders.argv) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    give_up(report_fd, "exec");
}

}  // namespace

StartedProgram start_program(const ShimOrders& orders) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {-1, errno, "pipe"};
    const FileDescriptor read_end(ends[0]);
    FileDescriptor write_end(ends[1]);
    const pid_t shim = getpid();
    const pid_t pid = fork();
    if (pid < 0) return {-1, errno, "fork"};
    if (pid == 0) become_program(orders, shim, write_end.get());
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
