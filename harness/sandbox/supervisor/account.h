// The account under which a student's program runs when root grades.
#pragma once

#include <sys/types.h>

#include <optional>

namespace harness {

struct Account {
    uid_t uid = 0;
    gid_t gid = 0;
};

/// Returns an unused account, a different one on each call. So programs that run at the same time can't reach each
/// other, and the kernel counts the processes of each separately. Empty if this process is not root (the program then
/// shares its account) or if its user namespace has no spare numbers.
std::optional<Account> spare_account();

/// Changes this process to `account` for good, without other groups. Only makes system calls, so a child may call it
/// after the fork of a process with threads. Returns false with errno if the kernel refuses.
bool become(const Account& account);

}  // namespace harness
