#include "harness/intake/confined_child.h"

#include <fcntl.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <initializer_list>
#include <new>

namespace harness {
namespace {

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

/// The size of this process's address space. Without /proc, a guess that is too high rather than too low.
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

/// Returns whether the memory limit is ours and not an earlier, lower one.
bool set_limits(const ChildLimits& limits) {
    lower(RLIMIT_CORE, 0, 0);
    lower(RLIMIT_FSIZE, 0, 0);
    const auto seconds = static_cast<rlim_t>(limits.cpu.count());
    lower(RLIMIT_CPU, seconds, seconds + 1);  // at the hard limit the kernel sends SIGKILL, which gives no reason
    if (is_sanitised) return true;
    const rlim_t most = used_addresses() + limits.memory_bytes;
    return lower(RLIMIT_AS, most, most);
}

void allow(scmp_filter_ctx filter, int call, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    // A system call that this architecture does not have cannot be made.
    seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, static_cast<unsigned>(arguments.size()),
                           arguments.size() == 0 ? nullptr : arguments.begin());
}

/// Forbids every system call that is not for memory, for `input` or for `pipe`. Forbidden calls fail with EPERM, so
/// that a library that looks for a file continues without it. On a kernel without seccomp only the limits apply.
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

}  // namespace

ConfinedChild::ConfinedChild(const ChildLimits& limits, int input, const std::function<void(int pipe)>& work)
    : child_("to read an archive", limits.wall, [&](int pipe) { run_child(limits, input, pipe, work); }) {}

ChildEnd ConfinedChild::end() {
    const std::optional<int> status = child_.end();
    if (child_.is_late()) return ChildEnd::wall_limit;
    if (!status) return ChildEnd::crashed;
    if (WIFSIGNALED(*status)) return WTERMSIG(*status) == SIGXCPU ? ChildEnd::cpu_limit : ChildEnd::crashed;
    switch (WEXITSTATUS(*status)) {
        case ended_well: return ChildEnd::done;
        case without_memory: return ChildEnd::memory_limit;
        case without_the_machines_memory: return ChildEnd::machine_memory;
        default: return ChildEnd::crashed;
    }
}

}  // namespace harness
