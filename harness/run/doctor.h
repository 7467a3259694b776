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
    std::string detail;   ///< what was found, with versions, paths and times; a line, or more for what was tried
    std::string way_out;  ///< a command or an action; empty when good
};

/// Looks, really attacks each sandbox and compiles and runs a small GLM program in the best; some two seconds. Never
/// throws: what fails is a finding.
std::vector<Finding> examine_machine();

}  // namespace harness
