// The limits of compiler and program. An instructor sets them by name, in [limits] of an assignment or with --limit.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "harness/execution/process_result.h"
#include "reference/toml/assignment.h"

namespace harness {

struct StageLimits {
    Limits compile, run;
};

/// One limit, described for people: a row of the table in manual/sandbox-and-limits.md and of --help.
struct LimitDescription {
    std::string name;         ///< "run.cpu_seconds"; the unit is part of it
    std::string value;        ///< the default
    std::string consequence;  ///< a sentence: what happens beyond it
};

/// All of them, in the order they are shown.
std::vector<LimitDescription> describe_limits();

/// Thrown if a limit can't be set this way. what() lists the existing limits or values.
class LimitError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The defaults, then the assignment's own, then `from_command_line`: each "name=value". A stage whose wall-clock limit
/// is not set gets at least five times its processor time, because on a busy machine a shorter limit would make the
/// outcome depend on the load. Throws AssignmentError about an entry of the assignment and LimitError about one of the
/// command line.
StageLimits read_limits(const std::vector<reference::LimitEntry>& from_assignment,
                        const std::vector<std::string>& from_command_line);

}  // namespace harness
