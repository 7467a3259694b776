#include "harness/intake/confined_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <initializer_list>
#include <new>
#include <system_error>

#include "harness/machine/errors.h"

namespace harness {
namespace {

using std::chrono::steady_clock;

/// AddressSanitizer needs terabytes of addresses and many system calls.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RAYGRADE_UNDER_ASAN
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define RAYGRADE_UNDER_ASAN
#endif
#if defined(RAYGRADE_UNDER_ASAN)
constexpr bool is_sanitised = true;
#else
constexpr bool is_sanitised = false;
#endif

/// Exit codes of the child.
enum ExitCode : int { ended_well = 0, without_memory = 3, without_the_machines_memory = 4, gave_up = 5 };

/// The addresses that this process uses. Without /proc a guess that is too high rather than too low.
rlim_t used_addresses() {
    unsigned long pages = 0;
    std::FILE* const file = std::fopen("/proc/self/statm", "re");
    const bool known = file != nullptr && std::fscanf(file, "%lu", &pages) == 1;
    if (file != nullptr) std::fclose(file);
    constexpr rlim_t guess = rlim_t{1} << 30U;
    return known ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : guess;
}

/// Lowers a limit of this process, the hard one to `hard`. Returns false if it was as low before.
bool lower(__rlimit_resource resource, rlim_t most, rlim_t hard) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0) return false;
    const bool was_lower = limit.rlim_cur <= most;
    limit.rlim_cur = std::min(limit.rlim_cur, most);
    limit.rlim_max = std::min(limit.rlim_max, hard);
    return setrlimit(resource, &limit) == 0 && !was_lower;
}

/// Returns whether the limit of memory is ours, not one that was there before.
bool set_limits(const ChildLimits& limits) {
    lower(RLIMIT_CORE, 0, 0);
    lower(RLIMIT_FSIZE, 0, 0);
    const auto seconds = static_cast<rlim_t>(limits.cpu.count());
    lower(RLIMIT_CPU, seconds, seconds + 1);  // at the hard limit the kernel sends SIGKILL, which says less
    if (is_sanitised) return true;
    const rlim_t most = used_addresses() + limits.memory_bytes;
    return lower(RLIMIT_AS, most, most);
}

void allow(scmp_filter_ctx filter, int call, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    // A call that this architecture does not have can't be made either.
    seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, static_cast<unsigned>(arguments.size()),
                           arguments.size() == 0 ? nullptr : arguments.begin());
}

/// Forbids every system call that is not for memory, for `input` or for `pipe`. What is forbidden fails with EPERM, so
/// that a library which looks for a file goes on without it. A kernel without seccomp leaves the limits alone.
void forbid_the_rest(int input, int pipe) {
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
    if (filter == nullptr) return;
    allow(filter, SCMP_SYS(write), {SCMP_A0_32(SCMP_CMP_EQ, static_cast<std::uint32_t>(pipe))});
    if (input >= 0) {
        const auto number = static_cast<std::uint32_t>(input);
        for (const int call : {SCMP_SYS(read), SCMP_SYS(lseek), SCMP_SYS(_llseek), SCMP_SYS(fstat), SCMP_SYS(fstat64)})
            allow(filter, call, {SCMP_A0_32(SCMP_CMP_EQ, number)});
        constexpr std::uint64_t lower_half = 0xffffffff;
        allow(filter, SCMP_SYS(newfstatat),  // the C library's fstat
              {SCMP_A0_32(SCMP_CMP_EQ, number), SCMP_A3_64(SCMP_CMP_MASKED_EQ, lower_half, AT_EMPTY_PATH)});
    }
    const scmp_arg_cmp not_executable = SCMP_A2_64(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
    const scmp_arg_cmp of_no_file = SCMP_A3_64(SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, MAP_ANONYMOUS);
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mmap2)}) allow(filter, call, {not_executable, of_no_file});
    allow(filter, SCMP_SYS(mprotect), {not_executable});
    for (const int call : {SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(futex),
                           SCMP_SYS(getrandom), SCMP_SYS(clock_gettime), SCMP_SYS(clock_gettime64), SCMP_SYS(exit),
                           SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn), SCMP_SYS(restart_syscall)})
        allow(filter, call);
    seccomp_load(filter);
    seccomp_release(filter);
}

[[noreturn]] void run_child(const ChildLimits& limits, int input, int pipe, const std::function<void(int)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGPIPE}) signal(number, SIG_DFL);
    const bool memory_is_ours = set_limits(limits);
    try {
        if (!is_sanitised) forbid_the_rest(input, pipe);
        work(pipe);
    } catch (const std::bad_alloc&) {
        _exit(memory_is_ours ? without_memory : without_the_machines_memory);
    } catch (...) {
        _exit(gave_up);
    }
    _exit(ended_well);
}

[[noreturn]] void fail_to_start(int error) {
    throw HarnessError(fmt::format(
        "No process could be started to read an archive: {}. See to this machine's memory and to `ulimit -u` and "
        "`ulimit -n`.",
        std::generic_category().message(error)));
}

ChildEnd end_of(int status) {
    if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGXCPU ? ChildEnd::cpu_limit : ChildEnd::crashed;
    switch (WEXITSTATUS(status)) {
        case ended_well: return ChildEnd::done;
        case without_memory: return ChildEnd::memory_limit;
        case without_the_machines_memory: return ChildEnd::machine_memory;
        default: return ChildEnd::crashed;
    }
}

}  // namespace

ConfinedChild::ConfinedChild(const ChildLimits& limits, int input, const std::function<void(int pipe)>& work)
    : limits_(limits), deadline_(steady_clock::now() + limits.wall) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(errno);
    pipe_ = FileDescriptor(ends[0]);
    FileDescriptor written(ends[1]);
    pid_ = fork();
    if (pid_ < 0) fail_to_start(errno);
    if (pid_ > 0) return;
    pipe_.close();  // so that it ends when its parent has
    run_child(limits, input, written.get(), work);
}

ConfinedChild::~ConfinedChild() {
    end();
}

bool ConfinedChild::wait_for_bytes() const {
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - steady_clock::now());
        if (left.count() <= 0) return false;
        pollfd waiting{pipe_.get(), POLLIN, 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 1'000'000)));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) return true;  // read will tell
    }
}

bool ConfinedChild::read(void* bytes, std::size_t size) {
    auto* to = static_cast<char*>(bytes);
    while (size > 0) {
        if (!wait_for_bytes()) {
            is_late_ = true;
            return false;
        }
        const ssize_t got = ::read(pipe_.get(), to, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        to += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

ChildEnd ConfinedChild::end() {
    if (pid_ < 0) return ChildEnd::crashed;
    // A child whose pipe has ended is ending itself: this does not change how.
    kill(pid_, SIGKILL);
    int status = 0;
    pid_t reaped = -1;
    while ((reaped = waitpid(pid_, &status, 0)) < 0 && errno == EINTR) {
    }
    const bool is_known = reaped == pid_;
    pid_ = -1;
    if (is_late_) return ChildEnd::wall_limit;
    return is_known ? end_of(status) : ChildEnd::crashed;
}

void write_all(int pipe, const void* bytes, std::size_t size) {
    const auto* from = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t put = write(pipe, from, size);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) _exit(gave_up);
        from += put;
        size -= static_cast<std::size_t>(put);
    }
}

}  // namespace harness
