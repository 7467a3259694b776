// Marks for Gradescope: the results.json of an autograder.
#pragma once

#include <string>

#include "harness/grade.h"

namespace harness::report {

/// What `run_autograder` leaves at /autograder/results/results.json (gradescope/autograder_samples, docs/specs.md): the
/// score, a test for each question, everything visible to the student and so without expected values, unless the rubric
/// shows them. All its texts together stay below the 100,000 characters beyond which Gradescope cuts. A submission that
/// does not compile has 0 points and the compiler's messages; one that was not graded no score and no tests, which
/// Gradescope takes for an autograder that failed, never for 0 points.
std::string gradescope_results(const Graded& graded, const Marking& marking);

}  // namespace harness::report
