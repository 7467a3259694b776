#include "harness/sandbox/supervisor/system_calls.h"

#include <asm/sockios.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <cerrno>
#include <thread>

#include "tests/given/sandbox/in_a_child.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::forbid_system_calls;
using harness::ForbiddenCalls;

constexpr int could_not_forbid = 200;

/// errno of a system call made under the filter; 0 on success.
template <class... Arguments>
int outcome(const ForbiddenCalls& more, long number, Arguments... arguments) {
    return in_a_child([&] {
        if (!forbid_system_calls(more)) return could_not_forbid;
        return syscall(number, arguments...) < 0 ? errno : 0;
    });
}

/// The kernel does not look at the upper half of such an argument.
long with_an_upper_half(long value) {
    return value | (1L << 32U);
}

TEST(ForbidSystemCalls, ForbidsCallsThatReachOutOfASandbox) {
    EXPECT_EQ(outcome({}, SYS_socket, AF_INET, SOCK_STREAM, 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_socket, AF_UNIX, SOCK_STREAM, 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_memfd_create, "x", 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_shmget, 0, 4096, 01600), EPERM);
    EXPECT_EQ(outcome({}, SYS_shmat, 0, nullptr, 0), EPERM) << "what others made";
    EXPECT_EQ(outcome({}, SYS_shmctl, 0, SHM_INFO, nullptr), EPERM);
    EXPECT_EQ(outcome({}, SYS_msgrcv, 0, nullptr, 0L, 0L, 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_semctl, 0, 0, IPC_RMID, 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_mq_unlink, "x"), EPERM);
    EXPECT_EQ(outcome({}, SYS_io_setup, 1, nullptr), EPERM);
    EXPECT_EQ(outcome({}, SYS_keyctl, 0, -4, 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_add_key, "user", "x", "y", 1, -4), EPERM);
    EXPECT_EQ(outcome({}, SYS_io_uring_setup, 1, nullptr), EPERM);
    EXPECT_EQ(outcome({}, SYS_ptrace, 0, 0, 0, 0), EPERM);
    EXPECT_EQ(outcome({}, SYS_unshare, CLONE_NEWUSER), EPERM);
    EXPECT_EQ(outcome({}, SYS_personality, 0xffffffff), EPERM);
}

TEST(ForbidSystemCalls, ForbidsANewUserNamespaceByEveryWay) {
    EXPECT_EQ(outcome({}, SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, 0L), EPERM);
    clone_args arguments{};
    arguments.flags = CLONE_NEWUSER;
    EXPECT_EQ(outcome({}, SYS_clone3, &arguments, sizeof arguments), ENOSYS);
}

TEST(ForbidSystemCalls, ForbidsTypingIntoATerminalEvenInDisguise) {
    const char letter = 'x';
    EXPECT_EQ(outcome({}, SYS_ioctl, 0L, static_cast<long>(TIOCSTI), &letter), EPERM);
    EXPECT_EQ(outcome({}, SYS_ioctl, 0L, with_an_upper_half(TIOCSTI), &letter), EPERM);
}

TEST(ForbidSystemCalls, ForbidsTakingResourcesFromTheParent) {
    const rlimit none{0, 0};
    EXPECT_EQ(outcome({}, SYS_prlimit64, getpid(), RLIMIT_NOFILE, nullptr, nullptr), EPERM);
    EXPECT_EQ(outcome({}, SYS_prlimit64, 0, RLIMIT_CORE, &none, nullptr), 0) << "its own are its own";
    EXPECT_EQ(outcome({}, SYS_setpriority, PRIO_PROCESS, getpid(), 19), EPERM);
    EXPECT_EQ(outcome({}, SYS_setpriority, PRIO_USER, 0, 19), EPERM) << "all that this account runs";
    EXPECT_EQ(outcome({}, SYS_setpriority, PRIO_PGRP, 0, 19), EPERM);
    EXPECT_EQ(outcome({}, SYS_setpriority, PRIO_PROCESS, 0, 19), 0);
    EXPECT_EQ(outcome({}, SYS_sched_setaffinity, getpid(), 0, nullptr), EPERM);
}

TEST(ForbidSystemCalls, ForbidsSignalsToOthersOnRequest) {
    const ForbiddenCalls signals{.signals = true, .file_attributes = false, .uncounted_use = false};
    EXPECT_EQ(outcome({}, SYS_kill, getpid(), 0), 0);
    EXPECT_EQ(outcome(signals, SYS_kill, getpid(), 0), EPERM);
    EXPECT_EQ(outcome(signals, SYS_kill, -1, 0), EPERM);
    EXPECT_EQ(outcome(signals, SYS_tkill, getpid(), 0), EPERM);
    EXPECT_EQ(outcome(signals, SYS_tgkill, getpid(), getpid(), 0), EPERM);
    EXPECT_EQ(outcome(signals, SYS_fcntl, 0L, static_cast<long>(F_SETOWN), getpid()), EPERM);
    EXPECT_EQ(outcome(signals, SYS_fcntl, 0L, with_an_upper_half(F_SETOWN), getpid()), EPERM);
    EXPECT_EQ(outcome(signals, SYS_ioctl, 0L, with_an_upper_half(SIOCSPGRP), nullptr), EPERM);
}

TEST(ForbidSystemCalls, ForbidsUncountedResourcesOnRequest) {
    const ForbiddenCalls uncounted{.signals = false, .file_attributes = false, .uncounted_use = true};
    const auto map = [](const ForbiddenCalls& more, int flags) {
        return outcome(more, SYS_mmap, nullptr, 4096L, PROT_READ, flags | MAP_ANONYMOUS, -1, 0L);
    };
    EXPECT_EQ(map({}, MAP_SHARED), 0);
    EXPECT_EQ(map(uncounted, MAP_SHARED), EPERM);
    EXPECT_EQ(map(uncounted, MAP_SHARED_VALIDATE), EPERM);
    EXPECT_EQ(map(uncounted, MAP_PRIVATE), 0);
    EXPECT_EQ(outcome(uncounted, SYS_vmsplice, 1, nullptr, 0L, 0), EPERM);
    const auto ignore = [](int number) {
        return in_a_child([=] {
            if (!forbid_system_calls({.signals = false, .file_attributes = false, .uncounted_use = true}))
                return could_not_forbid;
            struct sigaction action {};
            action.sa_handler = SIG_IGN;
            if (sigaction(number, nullptr, &action) != 0) return 1;
            action.sa_handler = SIG_IGN;
            return sigaction(number, &action, nullptr) == 0 ? 0 : errno;
        });
    };
    EXPECT_EQ(ignore(SIGCHLD), EPERM);
    EXPECT_EQ(ignore(SIGUSR1), 0);
}

TEST(ForbidSystemCalls, AllowsAProgramItsOwnSignals) {
    const auto aborts = in_a_child([] {
        if (!forbid_system_calls({.signals = true, .file_attributes = true, .uncounted_use = true}))
            return could_not_forbid;
        signal(SIGUSR1, SIG_IGN);
        if (kill(getpid(), SIGUSR1) != 0 || raise(SIGUSR1) != 0) return 1;
        abort();
    });
    EXPECT_EQ(aborts, 255);
}

TEST(ForbidSystemCalls, ForbidsFileAttributesOnRequest) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "text").string();
    const ForbiddenCalls attributes{.signals = false, .file_attributes = true, .uncounted_use = false};
    EXPECT_EQ(outcome({}, SYS_fchmodat, AT_FDCWD, file.c_str(), 0600), 0);
    EXPECT_EQ(outcome(attributes, SYS_fchmodat, AT_FDCWD, file.c_str(), 0600), EPERM);
    constexpr long fchmodat2 = 452;
    EXPECT_EQ(outcome(attributes, fchmodat2, AT_FDCWD, file.c_str(), 0600, 0), EPERM);
    EXPECT_EQ(outcome(attributes, SYS_utimensat, AT_FDCWD, file.c_str(), nullptr, 0), EPERM);
    EXPECT_EQ(outcome(attributes, SYS_truncate, file.c_str(), 0L), EPERM);
    EXPECT_EQ(outcome(attributes, SYS_getxattr, file.c_str(), "user.x", nullptr, 0L), EPERM);
    EXPECT_EQ(outcome(attributes, SYS_setxattr, file.c_str(), "user.x", "y", 1L, 0), EPERM);
}

TEST(ForbidSystemCalls, AllowsThreadsAndChildren) {
    const auto works = in_a_child([] {
        if (!forbid_system_calls({.signals = true, .file_attributes = true, .uncounted_use = true}))
            return could_not_forbid;
        int value = 0;
        std::thread([&] { value = 1; }).join();
        return value == 1 && in_a_child([] { return 7; }) == 7 ? 0 : 1;
    });
    EXPECT_EQ(works, 0);
}

}  // namespace
