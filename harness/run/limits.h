// The limits of compiler and program as an instructor sets them: by name, in [limits] of an assignment or with --limit.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "harness/sandbox/process.h"
#include "reference/assignment.h"

namespace harness {

struct StageLimits {
    Limits compile, run;
};

/// One limit for people: a row of README's table and of --help.
struct LimitDescription {
    std::string name;         ///< "run.cpu_seconds"; the unit is part of it
    std::string value;        ///< the default
    std::string consequence;  ///< a sentence: what happens beyond it
};

/// All of them, in the order they are shown.
std::vector<LimitDescription> describe_limits();

/// The limit can't be set so. what() says which limits or values there are.
class LimitError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The defaults, then the assignment's own, then `from_command_line`: each "name=value". Without a wall-clock limit of
/// its own a stage has one of at least five times its processor time: on a busy machine a shorter one would decide by
/// the load. Throws AssignmentError about an entry of the assignment and LimitError about one of the command line.
StageLimits read_limits(const std::vector<reference::LimitEntry>& from_assignment,
                        const std::vector<std::string>& from_command_line);

}  // namespace harness
