// What this machine has and lacks for grading.
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
    std::string detail;   ///< what was found, with versions, paths and times; several lines if it lists attempts
    std::string way_out;  ///< a command or an action; empty when good
};

/// What the kernel and a container say of user namespaces. Empty strings where the kernel has no such setting.
struct NamespaceSettings {
    std::string apparmor_restricts;  ///< kernel.apparmor_restrict_unprivileged_userns
    std::string clone_allowed;       ///< kernel.unprivileged_userns_clone
    std::string most;                ///< user.max_user_namespaces
    bool filters_calls = false;      ///< a seccomp filter is on, as in a container
};

/// What to do so that bubblewrap, which is installed and failed with the message `failure`, can make its namespaces.
std::string way_to_namespaces(const std::string& failure, const NamespaceSettings& settings);

/// Examines the machine: attacks each sandbox from inside, then compiles and runs a small GLM program in the strongest
/// one. Takes about two seconds. Never throws: a failure becomes a finding.
std::vector<MachineFinding> examine_machine();

}  // namespace harness
