// Whom a stranger's program runs as when root grades.
#pragma once

#include <sys/types.h>

#include <optional>

namespace harness {

struct Account {
    uid_t uid = 0;
    gid_t gid = 0;
};

/// An account that nobody has, and another one each time, so that programs that run at the same time can't reach each
/// other and the kernel counts the processes of each on its own. Empty when this process is not root, whose account
/// the program then shares, or when the user namespace it runs in has no numbers to spare.
std::optional<Account> spare_account();

/// Becomes `account` for good, without other groups. For a child about to start a program: makes system calls alone,
/// so it may follow a fork of a process with threads. False with errno when the kernel refuses.
bool become(const Account& account);

}  // namespace harness
