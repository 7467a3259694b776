// Checks whether this machine is ready for grading.
#pragma once

#include <string>
#include <vector>

namespace harness {

struct MachineFinding {
    enum class Level {
        good,
        warning,  ///< grading works, but not as well
        bad,      ///< nothing can be graded
    };
    std::string what;  ///< a few words: "compiler"
    Level level = Level::good;
    std::string detail;   ///< the finding, with versions, paths and times; several lines if it lists attempts
    std::string way_out;  ///< a command or an action; empty if good
};

/// The settings of the kernel and a container for user namespaces. A string is empty if the kernel has no such setting.
struct NamespaceSettings {
    std::string apparmor_restricts;  ///< kernel.apparmor_restrict_unprivileged_userns
    std::string clone_allowed;       ///< kernel.unprivileged_userns_clone
    std::string most;                ///< user.max_user_namespaces
    bool filters_calls = false;      ///< a seccomp filter is active, as in a container
};

/// The fix that lets bubblewrap make its namespaces. bubblewrap is installed but failed with the message `failure`.
std::string way_to_namespaces(const std::string& failure, const NamespaceSettings& settings);

/// Examines the machine: attacks each sandbox from inside, then compiles and runs a small GLM program in the strongest
/// one. Takes about two seconds. Never throws: a failure becomes a finding.
std::vector<MachineFinding> examine_machine();

}  // namespace harness
