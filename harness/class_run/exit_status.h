#pragma once

namespace harness {

/// The exit status of raygrade. Marks never change it, except under `check --fail-under`.
enum ExitStatus : int {
    all_graded = 0,
    some_not_graded = 1,  ///< also if a check gave no marks or too few
    usage = 2,            ///< the command line, a path or an assignment is wrong; nothing was graded
    our_fault = 3,
};

}  // namespace harness
