// Makes the command line of bubblewrap. See bwrap(1).
#pragma once

#include <string>
#include <vector>

#include "harness/sandbox/host/command.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// The command line up to and including the supervisor's path, without its orders: new namespaces of every kind and a
/// read-only root. The root contains only the supervisor, system_folders, `readable` and the working directory, which
/// only a compiler may write. `sandbox` must be of tier bwrap.
std::vector<std::string> bwrap_arguments(const Command& command, const Sandbox& sandbox);

}  // namespace harness
