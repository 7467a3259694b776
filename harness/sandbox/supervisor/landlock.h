// Landlock restricts which files a process may access, on machines without user namespaces. See landlock(7).
#pragma once

#include <string>
#include <vector>

namespace harness {

/// The version of Landlock this kernel has, 1 or more; 0 for none.
int landlock_version();

/// Denies this process and its children, for good, every file that is not at or below a path of `readable` or
/// `writable`, all TCP and, if the kernel supports it, signals to processes other than its own children. Paths are
/// absolute; missing ones are ignored. Readable files may be executed. Expects no_new_privs. Returns false with errno
/// if the kernel refuses.
///
/// Landlock does not hide whether a path exists, and does not protect the mode, owner and times of a file that its user
/// owns. The filter of system_calls.h must forbid changing these, and before version 3 truncating files by path.
bool restrict_files(const std::vector<std::string>& readable, const std::vector<std::string>& writable);

}  // namespace harness
