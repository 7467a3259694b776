// Forbids system calls that reach beyond a sandbox and that no student's program and no compiler needs.
#pragma once

namespace harness {

struct ForbiddenCalls {
    /// Signals to any process but the program's first. Without a process namespace and without Landlock's rule for
    /// signals, the program could signal the supervisor and all other processes of this user.
    bool signals = false;
    /// Changing mode, owner, times or attributes of a file, or its length by path, and reading its attributes. Landlock
    /// allows all of these.
    bool file_attributes = false;
    /// Uses of memory or time that nobody could count: shared memory, which stays in use when no process has it mapped,
    /// and any but the default action for SIGCHLD, because ignoring it makes the kernel forget the use of ended
    /// children.
    bool uncounted_use = false;
};

/// Makes these calls fail with EPERM in this process and its children: sockets, other processes' memory, limits and
/// scheduling, System V and POSIX IPC, memfd, io_uring, keyrings, BPF, mounts, new namespaces, and those of `more`.
/// clone3 fails with ENOSYS, so the C library uses clone. Expects no_new_privs. Returns false with errno on failure.
bool forbid_system_calls(const ForbiddenCalls& more);

}  // namespace harness
