// Landlock: the kernel's own way to take files away from a process, for machines without user namespaces.
// See landlock(7).
#pragma once

#include <string>
#include <vector>

namespace harness {

/// The version of Landlock this kernel has, 1 or more; 0 for none.
int landlock_version();

/// Takes from this process and its children, for good, every file that is not at or below one of `readable` or
/// `writable` (absolute; one that does not exist is left out), all TCP, and where the kernel can, signals to processes
/// other than its own children. What is readable may be executed. Expects no_new_privs. False with errno when the
/// kernel refuses.
///
/// Landlock leaves alone: whether a path exists, and the mode, owner and times of a file its user owns. The filter of
/// system_calls.h has to take care of the latter, and of truncating files by path before version 3.
bool restrict_files(const std::vector<std::string>& readable, const std::vector<std::string>& writable);

}  // namespace harness
