// The command line of bubblewrap. See bwrap(1).
#pragma once

#include <string>
#include <vector>

#include "harness/sandbox/sandbox.h"

namespace harness {

/// Everything up to the supervisor and its orders: new namespaces of every kind, a read-only root that holds the
/// supervisor, system_folders, `readable` and the working directory and nothing else, which only a compiler may write.
/// `sandbox` is of tier bwrap.
std::vector<std::string> bwrap_arguments(const Command& command, const Sandbox& sandbox);

}  // namespace harness
