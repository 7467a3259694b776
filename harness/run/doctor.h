// What this machine has and lacks for grading.
#pragma once

#include <string>
#include <vector>

namespace harness {

struct Finding {
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

/// Examines the machine: attacks each sandbox from inside, then compiles and runs a small GLM program in the strongest
/// one. Takes about two seconds. Never throws: a failure becomes a finding.
std::vector<Finding> examine_machine();

}  // namespace harness
