// Marks for Gradescope: the results.json of an autograder.
#pragma once

#include <string>
#include <string_view>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Appears in the first 1,000 bytes of each results.json, whatever students write into it.
inline constexpr std::string_view gradescope_mark = "\"stdout_visibility\"";

/// The file that `run_autograder` writes to /autograder/results/results.json (gradescope/autograder_samples,
/// docs/specs.md): the score and a test for each question. Students see all of it, so it has no expected values unless
/// the rubric shows them. All its texts together stay below 100,000 characters, where Gradescope cuts them. A
/// submission that does not compile has 0 points and the compiler's messages. A submission that was not graded has no
/// score and no tests; Gradescope treats that as a failed autograder, never as 0 points.
std::string gradescope_results(const Graded& graded, const Marking& marking);

/// The same for a submission that could not be read, or after a failure of the machine. There is no score, and `output`
/// tells the student why.
std::string gradescope_without_score(const std::string& output);

}  // namespace harness::report
