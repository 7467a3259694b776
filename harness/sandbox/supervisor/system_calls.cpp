#include "harness/sandbox/supervisor/system_calls.h"

#include <asm/sockios.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <initializer_list>

namespace harness {
namespace {

// These calls are newer than Debian 12's headers. New calls have the same number on every architecture.
constexpr int fchmodat2 = 452, statmount = 457, listmount = 458, setxattrat = 463, getxattrat = 464, listxattrat = 465,
              removexattrat = 466, file_setattr = 469;

/// A filter under construction. Keeps the first error as a negative errno, as libseccomp returns it, or 0.
class Filter {
  public:
    Filter() : context_(seccomp_init(SCMP_ACT_ALLOW)) {
        if (context_ == nullptr) failed_ = -ENOMEM;
    }
    ~Filter() {
        if (context_ != nullptr) seccomp_release(context_);
    }
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;

    void forbid(std::initializer_list<int> calls) {
        for (const int call : calls) add(SCMP_ACT_ERRNO(EPERM), call, {});
    }
    /// Forbids the call only if its arguments compare like this.
    void forbid_if(int call, std::initializer_list<scmp_arg_cmp> arguments) {
        add(SCMP_ACT_ERRNO(EPERM), call, arguments);
    }
    void pretend_missing(int call) { add(SCMP_ACT_ERRNO(ENOSYS), call, {}); }

    /// Activates the filter; 0 or a negative errno.
    int load() {
        if (failed_ == 0) failed_ = seccomp_load(context_);
        return failed_;
    }

  private:
    void add(std::uint32_t action, int call, std::initializer_list<scmp_arg_cmp> arguments) {
        if (failed_ != 0) return;
        failed_ = seccomp_rule_add_array(context_, action, call, static_cast<unsigned>(arguments.size()),
                                         arguments.size() == 0 ? nullptr : arguments.begin());
        // This architecture has no such call, so no program can make it.
        if (failed_ == -EDOM) failed_ = 0;
    }

    scmp_filter_ctx context_;
    int failed_ = 0;
};

/// The kernel reads only the lower half of such an argument, so the filter must ignore the upper half.
scmp_arg_cmp argument_is(unsigned number, std::uint64_t value) {
    constexpr std::uint64_t lower_half = 0xffffffff;
    return SCMP_CMP64(number, SCMP_CMP_MASKED_EQ, lower_half, value);
}

void forbid_what_reaches_out(Filter& filter) {
    filter.forbid({SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(socketcall)});
    // Forbids creating such objects and using existing ones.
    filter.forbid({SCMP_SYS(ipc), SCMP_SYS(shmget), SCMP_SYS(shmat), SCMP_SYS(shmctl), SCMP_SYS(msgget),
                   SCMP_SYS(msgsnd), SCMP_SYS(msgrcv), SCMP_SYS(msgctl), SCMP_SYS(semget), SCMP_SYS(semop),
                   SCMP_SYS(semtimedop), SCMP_SYS(semctl), SCMP_SYS(mq_open), SCMP_SYS(mq_unlink),
                   SCMP_SYS(memfd_create), SCMP_SYS(memfd_secret)});
    filter.forbid({SCMP_SYS(keyctl), SCMP_SYS(add_key), SCMP_SYS(request_key)});
    filter.forbid({SCMP_SYS(io_uring_setup), SCMP_SYS(io_uring_enter), SCMP_SYS(io_uring_register), SCMP_SYS(io_setup),
                   SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd), SCMP_SYS(inotify_init),
                   SCMP_SYS(inotify_init1), SCMP_SYS(fanotify_init), SCMP_SYS(syslog)});
    filter.forbid({SCMP_SYS(mount), SCMP_SYS(umount), SCMP_SYS(umount2), SCMP_SYS(pivot_root), SCMP_SYS(chroot),
                   SCMP_SYS(fsopen), SCMP_SYS(fsconfig), SCMP_SYS(fsmount), SCMP_SYS(fspick), SCMP_SYS(open_tree),
                   SCMP_SYS(move_mount), SCMP_SYS(mount_setattr), SCMP_SYS(open_by_handle_at), statmount, listmount});
    filter.forbid({SCMP_SYS(unshare), SCMP_SYS(setns), SCMP_SYS(personality)});
    // Input into a terminal.
    filter.forbid_if(SCMP_SYS(ioctl), {argument_is(1, TIOCSTI)});
    filter.forbid_if(SCMP_SYS(ioctl), {argument_is(1, TIOCLINUX)});
}

/// clone's flags are its first argument, or its second on s390.
void forbid_new_namespaces(Filter& filter) {
#if defined(__s390__)
    constexpr unsigned flags = 1;
#else
    constexpr unsigned flags = 0;
#endif
    filter.forbid_if(SCMP_SYS(clone), {SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER)});
    // clone3's flags are in memory, which a filter cannot read.
    filter.pretend_missing(SCMP_SYS(clone3));
}

/// The supervisor has the program's user even with namespaces. A program that takes away the supervisor's processor
/// time or descriptors would run unsupervised.
void forbid_meddling_with_processes(Filter& filter) {
    filter.forbid({SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(process_madvise),
                   SCMP_SYS(process_mrelease), SCMP_SYS(kcmp), SCMP_SYS(pidfd_getfd), SCMP_SYS(move_pages),
                   SCMP_SYS(migrate_pages)});
    filter.forbid_if(SCMP_SYS(prlimit64), {SCMP_A0_32(SCMP_CMP_NE, 0)});
    filter.forbid_if(SCMP_SYS(sched_setscheduler), {SCMP_A0_32(SCMP_CMP_NE, 0)});
    filter.forbid_if(SCMP_SYS(sched_setparam), {SCMP_A0_32(SCMP_CMP_NE, 0)});
    filter.forbid_if(SCMP_SYS(sched_setattr), {SCMP_A0_32(SCMP_CMP_NE, 0)});
    filter.forbid_if(SCMP_SYS(sched_setaffinity), {SCMP_A0_32(SCMP_CMP_NE, 0)});
    // Allowed only for the calling process itself (0), not for a group or a whole account.
    constexpr std::uint32_t io_of_a_process = 1;  // IOPRIO_WHO_PROCESS
    filter.forbid_if(SCMP_SYS(setpriority), {SCMP_A0_32(SCMP_CMP_NE, PRIO_PROCESS)});
    filter.forbid_if(SCMP_SYS(setpriority), {SCMP_A1_32(SCMP_CMP_NE, 0)});
    filter.forbid_if(SCMP_SYS(ioprio_set), {SCMP_A0_32(SCMP_CMP_NE, io_of_a_process)});
    filter.forbid_if(SCMP_SYS(ioprio_set), {SCMP_A1_32(SCMP_CMP_NE, 0)});
}

void forbid_signals_to_others(Filter& filter) {
    const auto own = static_cast<std::uint32_t>(getpid());
    filter.forbid_if(SCMP_SYS(kill), {SCMP_A0_32(SCMP_CMP_NE, own)});
    filter.forbid_if(SCMP_SYS(tgkill), {SCMP_A0_32(SCMP_CMP_NE, own)});
    filter.forbid({SCMP_SYS(tkill), SCMP_SYS(rt_sigqueueinfo), SCMP_SYS(pidfd_send_signal)});
    filter.forbid_if(SCMP_SYS(rt_tgsigqueueinfo), {SCMP_A0_32(SCMP_CMP_NE, own)});
    // Making another process a descriptor's owner would send it signals of the program's choice.
    for (const std::uint64_t command : {F_SETOWN, F_SETOWN_EX})
        filter.forbid_if(SCMP_SYS(fcntl), {argument_is(1, command)});
    for (const std::uint64_t request : {FIOSETOWN, SIOCSPGRP})
        filter.forbid_if(SCMP_SYS(ioctl), {argument_is(1, request)});
}

void forbid_uncounted_use(Filter& filter) {
    // Shared mappings, also of /dev/zero. MAP_SHARED_VALIDATE has this bit as well.
    constexpr unsigned flags = 3;
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mmap2)}) {
        filter.forbid_if(call, {SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, MAP_SHARED, MAP_SHARED)});
    }
    // vmsplice can leave pages that only a pipe owns.
    filter.forbid({SCMP_SYS(vmsplice)});
    filter.forbid_if(SCMP_SYS(rt_sigaction), {argument_is(0, SIGCHLD), SCMP_A1_64(SCMP_CMP_NE, 0)});
}

void forbid_file_attributes(Filter& filter) {
    filter.forbid({SCMP_SYS(chmod),        SCMP_SYS(fchmod),     SCMP_SYS(fchmodat),    SCMP_SYS(chown),
                   SCMP_SYS(fchown),       SCMP_SYS(lchown),     SCMP_SYS(fchownat),    SCMP_SYS(utime),
                   SCMP_SYS(utimes),       SCMP_SYS(utimensat),  SCMP_SYS(futimesat),   SCMP_SYS(setxattr),
                   SCMP_SYS(lsetxattr),    SCMP_SYS(fsetxattr),  SCMP_SYS(removexattr), SCMP_SYS(lremovexattr),
                   SCMP_SYS(fremovexattr), SCMP_SYS(getxattr),   SCMP_SYS(lgetxattr),   SCMP_SYS(fgetxattr),
                   SCMP_SYS(listxattr),    SCMP_SYS(llistxattr), SCMP_SYS(flistxattr),  SCMP_SYS(truncate),
                   SCMP_SYS(truncate64)});
    filter.forbid({fchmodat2, setxattrat, getxattrat, listxattrat, removexattrat, file_setattr});
}

}  // namespace

bool forbid_system_calls(const ForbiddenCalls& more) {
    Filter filter;
    forbid_what_reaches_out(filter);
    forbid_new_namespaces(filter);
    forbid_meddling_with_processes(filter);
    if (more.signals) forbid_signals_to_others(filter);
    if (more.file_attributes) forbid_file_attributes(filter);
    if (more.uncounted_use) forbid_uncounted_use(filter);
    const int failed = filter.load();
    if (failed != 0) errno = -failed;
    return failed == 0;
}

}  // namespace harness
