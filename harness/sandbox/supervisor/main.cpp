// The supervisor: a small process between the harness and a student's program.
//
// Theory of operation. The harness starts one supervisor for a program, which runs it once or several times, one after
// the other, each time with other descriptors. The supervisor makes itself the reaper of all its
// descendants, so that a daemon that leaves its parent and its session becomes a child of the supervisor and not of
// init. As long as a process of the program lives, the supervisor has a child; when wait reports no child, no process
// is left. It starts the program (program.cpp) and then sleeps until a child ends, 20 ms are over, or the lifeline
// closes. The lifeline is a pipe whose other end only the harness holds: it closes when the harness wants to end the
// run and when the harness dies, even of SIGKILL. Every 20 ms the supervisor adds up the processor time, memory and
// tasks of the whole tree. When the program ends or a limit is reached, it kills and reaps until nothing is left, and
// writes one status line to a descriptor the program never had. So a run finds nothing of the run before: no process of
// it lives, and no sandbox lets a program write a file or make an object that outlives its processes.
//
// The supervisor measures because no other process can: a child's peak memory starts at that of the process it was
// forked from, and the harness is big; only the process that reaps the whole tree learns its processor time. Statically
// linked, it starts in a millisecond and needs nothing inside a sandbox. It trusts its command line, which only the
// harness writes.
//
// The program can't reach the supervisor. With namespaces the supervisor is their first process, which the kernel lets
// nobody inside kill. With Landlock the filter of system calls protects it, or it belongs to root while the program has
// another account. Without a sandbox a program of the same user can kill or stop it; then the harness gets no status
// line, or none in time, and handles that.

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/machine/file_descriptor.h"
#include "harness/sandbox/supervisor/process_tree.h"
#include "harness/sandbox/supervisor/program.h"
#include "harness/sandbox/supervisor/protocol.h"

namespace harness {
namespace {

using Clock = std::chrono::steady_clock;
using How = SupervisorStatus::How;
using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr milliseconds between_checks{20};
/// Sooner than the later checks, because many programs run only briefly.
constexpr milliseconds before_first_check{5};

microseconds total(const rusage& usage) {
    return std::chrono::seconds(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           microseconds(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The number of processes that the kernel has killed for lack of memory since it started.
std::uint64_t out_of_memory_kills() {
    std::ifstream file("/proc/vmstat");
    for (std::string name, value; file >> name >> value;) {
        if (name == "oom_kill") return std::strtoull(value.c_str(), nullptr, 10);
    }
    return 0;
}

/// Everything known about the program's tree while it runs.
struct Watch {
    const Limits& limits;
    pid_t program;
    std::vector<pid_t> strangers;  ///< sorted; older than the program, so not its descendants while they live
    Clock::time_point start = Clock::now();
    std::optional<int> wait_status{};  ///< of the program, once it has ended
    std::uint64_t peak_memory_bytes = 0;
    std::uint64_t kills_before = 0;  ///< out_of_memory_kills
    microseconds cpu_before{0};      ///< reaped_cpu, of earlier runs
};

/// Reaps every child that has ended. Returns false if no child is left.
bool reap(Watch& watch) {
    for (;;) {
        int status = 0;
        rusage usage{};
        const pid_t pid = wait4(-1, &status, WNOHANG | __WALL, &usage);
        if (pid == 0) return true;
        if (pid < 0 && errno == EINTR) continue;
        if (pid < 0) return false;
        if (pid == watch.program) watch.wait_status = status;
        watch.peak_memory_bytes =
            std::max(watch.peak_memory_bytes, static_cast<std::uint64_t>(usage.ru_maxrss) * std::uint64_t{1024});
    }
}

microseconds reaped_cpu() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return total(usage);
}

/// The limit that the living tree has exceeded, if any.
std::optional<How> check_tree(Watch& watch) {
    microseconds cpu = reaped_cpu() - watch.cpu_before;
    std::uint64_t memory_bytes = 0;
    int tasks = 0;
    for (const auto& process : below(getpid(), list_processes_except(watch.strangers))) {
        cpu += process.cpu;
        memory_bytes += process.memory_bytes + hidden_memory_bytes(process);
        if (!process.zombie) tasks += process.threads;
    }
    watch.peak_memory_bytes = std::max(watch.peak_memory_bytes, memory_bytes);
    if (cpu > watch.limits.cpu) return How::cpu_limit;
    if (memory_bytes > watch.limits.memory_bytes) return How::memory_limit;
    if (tasks > watch.limits.processes) return How::process_limit;
    return std::nullopt;
}

/// Sleeps until a child ends, the lifeline closes or `longest` is over. Returns true if the lifeline is closed.
bool sleep_until_news(int child_fd, int lifeline_fd, milliseconds longest) {
    pollfd waiting[2] = {{child_fd, POLLIN, 0}, {lifeline_fd, 0, 0}};
    poll(waiting, 2, static_cast<int>(std::max(longest.count(), milliseconds::rep{0})));
    // One read only: a flood of ending children could keep a loop busy.
    signalfd_siginfo ignored;
    [[maybe_unused]] const ssize_t size = read(child_fd, &ignored, sizeof ignored);
    return (waiting[1].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

/// Watches the tree until the program has ended (then empty) or there is another reason to end it.
std::optional<How> watch_tree(Watch& watch, int child_fd, int lifeline_fd) {
    const auto end = watch.start + watch.limits.wall;
    auto next_check = watch.start + before_first_check;
    for (;;) {
        reap(watch);
        if (watch.wait_status) return std::nullopt;
        const auto now = Clock::now();
        if (now >= end) return How::wall_limit;
        // Checks only when due: a flood of ending children must not make the supervisor walk /proc all the time.
        if (now >= next_check) {
            if (const auto limit = check_tree(watch)) return limit;
            next_check = Clock::now() + between_checks;
        }
        const auto pause = std::chrono::ceil<milliseconds>(std::min(end, next_check) - Clock::now());
        if (sleep_until_news(child_fd, lifeline_fd, pause)) return How::lifeline_cut;
    }
}

/// Kills until no process is left to reap.
void end_tree(Watch& watch, int child_fd, int lifeline_fd) {
    while (reap(watch)) {
        kill_below(getpid());
        if (reap(watch)) sleep_until_news(child_fd, lifeline_fd, milliseconds(1));
    }
}

/// A program that exceeded a limit gets that verdict even if it ended between two checks, so that the same program
/// always gets the same verdict.
SupervisorStatus conclude(const Watch& watch, std::optional<How> cause, microseconds wall) {
    SupervisorStatus status;
    status.cpu = reaped_cpu() - watch.cpu_before;
    status.wall = wall;
    status.peak_memory_bytes = watch.peak_memory_bytes;
    status.machine_ran_out_of_memory = out_of_memory_kills() != watch.kills_before;
    const int wait_status = watch.wait_status.value_or(0);
    const bool exited = WIFEXITED(wait_status);
    status.number = exited ? WEXITSTATUS(wait_status) : cause ? 0 : WTERMSIG(wait_status);
    if (!cause && status.cpu > watch.limits.cpu) cause = How::cpu_limit;
    if (!cause && status.peak_memory_bytes > watch.limits.memory_bytes) cause = How::memory_limit;
    status.how = cause.value_or(exited ? How::exited : How::signalled);
    return status;
}

/// Protects the supervisor from the program as far as possible without a sandbox. Returns null, or the step that
/// failed.
const char* harden() {
    if (prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0) return "subreaper";
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return "no_new_privs";
    if (prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0) return "dumpable";
    // Real-time priority: a fork bomb of a thousand processes would leave the supervisor a thousandth of the processor
    // time. Only root may set it, and only root needs it: for other users the kernel enforces RLIMIT_NPROC. The program
    // does not inherit it.
    const sched_param lowest_real_time = {.sched_priority = 1};
    sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &lowest_real_time);
    return nullptr;
}

/// Blocks every signal that can be blocked. The returned descriptor reports ended children.
FileDescriptor listen_for_children() {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, nullptr);
    sigset_t children;
    sigemptyset(&children);
    sigaddset(&children, SIGCHLD);
    return FileDescriptor(signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK));
}

/// Points the given descriptor at /dev/null.
bool silence(int descriptor) {
    const FileDescriptor null(open("/dev/null", O_RDWR | O_CLOEXEC));
    return null && dup2(null.get(), descriptor) >= 0;
}

std::vector<pid_t> running_now() {
    std::vector<pid_t> pids;
    for (const auto& process : list_processes()) pids.push_back(process.pid);
    std::sort(pids.begin(), pids.end());
    return pids;
}

SupervisorStatus not_executed(int error, const std::string& step) {
    SupervisorStatus status;
    status.number = error;
    status.step = step;
    return status;
}

/// Runs the program once, with the standard descriptors as they are.
SupervisorStatus supervise(const SupervisorOrders& orders, int child_fd) {
    const auto strangers = running_now();
    const auto kills_before = out_of_memory_kills();
    const auto cpu_before = reaped_cpu();
    const auto start = Clock::now();
    const StartedProgram program = start_program(orders);
    if (program.pid < 0) return not_executed(program.failed_errno, program.failed_step);
    // The supervisor must not keep the pipes open: they should close when the program's last process has ended.
    silence(STDOUT_FILENO);
    silence(STDERR_FILENO);
    Watch watch{orders.limits, program.pid, strangers, start};
    watch.kills_before = kills_before;
    watch.cpu_before = cpu_before;
    auto cause = watch_tree(watch, child_fd, orders.lifeline_fd);
    // The limits also apply to processes that the program leaves behind.
    if (!cause && reap(watch)) cause = check_tree(watch);
    const auto wall = std::chrono::duration_cast<microseconds>(Clock::now() - start);
    end_tree(watch, child_fd, orders.lifeline_fd);
    return conclude(watch, cause, wall);
}

/// Makes these the standard descriptors, and closes their old numbers.
bool use(const StandardDescriptors& descriptors) {
    for (const auto& [from, to] :
         {std::pair(descriptors.input, STDIN_FILENO), std::pair(descriptors.output, STDOUT_FILENO),
          std::pair(descriptors.errors, STDERR_FILENO)}) {
        if (dup2(from, to) < 0) return false;
        close(from);
    }
    return true;
}

bool tell(const SupervisorStatus& status, int status_fd) {
    const std::string line = to_line(status);
    return write(status_fd, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

/// Runs the program as often as ordered, or until a run is cut short. Returns false if the result cannot be written.
bool supervise_all(const SupervisorOrders& orders) {
    fcntl(orders.status_fd, F_SETFD, FD_CLOEXEC);
    fcntl(orders.lifeline_fd, F_SETFD, FD_CLOEXEC);
    const auto fail = [&](const char* step) { return tell(not_executed(errno, step), orders.status_fd); };
    if (const char* failed = harden()) return fail(failed);
    const FileDescriptor child_fd = listen_for_children();
    if (!child_fd) return fail("signalfd");
    if (!orders.has_input && !silence(STDIN_FILENO)) return fail("open-dev-null");
    for (std::size_t run = 0; run <= orders.further_runs.size(); ++run) {
        if (run > 0 && !use(orders.further_runs[run - 1])) return fail("dup2");
        const SupervisorStatus status = supervise(orders, child_fd.get());
        if (!tell(status, orders.status_fd)) return false;
        if (status.how == How::lifeline_cut) break;
    }
    return true;
}

}  // namespace
}  // namespace harness

int main(int argc, char** argv) {
    const auto orders = harness::from_arguments(std::vector<std::string>(argv + 1, argv + argc));
    if (!orders) return 2;
    return harness::supervise_all(*orders) ? 0 : 1;
}
