// The system calls no student's program and no compiler needs, and that reach beyond a sandbox.
#pragma once

namespace harness {

struct ForbiddenCalls {
    /// Signals to any process but the program's first. Where there is no process namespace and Landlock has
    /// no say, the supervisor and everything else of this user would be within reach.
    bool signals = false;
    /// Changing mode, owner, times or attributes of a file, or its length by path, which Landlock lets pass, and
    /// reading its attributes.
    bool file_attributes = false;
    /// What would take memory or time that nobody could count: shared memory, which stays in use when no process has it
    /// mapped, and another way to deal with SIGCHLD than the default, as ignoring it makes the kernel forget what ended
    /// children used.
    bool uncounted_use = false;
};

/// From here on these calls fail with EPERM in this process and its children: sockets, other processes' memory, limits
/// and scheduling, System V and POSIX IPC, memfd, io_uring, keyrings, BPF, mounts, new namespaces, and those of
/// `more`; clone3 fails with ENOSYS, upon which the C library takes clone. Expects no_new_privs. False with errno when
/// it could not be done.
bool forbid_system_calls(const ForbiddenCalls& more);

}  // namespace harness
