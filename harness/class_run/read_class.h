// A class as a command names it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"

namespace harness {

struct ClassSources {
    std::vector<std::filesystem::path> paths;
    std::string assignment;         ///< empty for the one of the results of an earlier run, else the default
    std::filesystem::path results;  ///< the folder that an earlier run wrote, for what that run had been told
    RosterOptions rosters{};
};

/// Reads the class, and says on stderr what of it is left out. Throws UsageError, also if it can't be graded as
/// `grading` says.
ClassInputs read_class(const ClassSources& sources, const GradingOptions& grading);

}  // namespace harness
