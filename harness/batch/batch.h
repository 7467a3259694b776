// A class through the main path of grade_submission.h: what is compiled and run when, so that no core waits.
#pragma once

#include <vector>

#include "harness/batch/grade_submission.h"

namespace harness {

/// Grades a class: at most `jobs` (at least 1) submissions are compiled and as many run at a time. The results are in
/// the order given; they do not depend on the number of jobs, the order of finishing or what the cache holds. A failure
/// of the machine or of raygrade makes that submission not_graded, and the others go on. `timeline` is filled
/// meanwhile. Where scenes are dealt, each submission is held to its student's.
std::vector<Graded> grade_all(std::vector<Submission> submissions, const Marking& marking, const Runner& runner,
                              int jobs, Timeline& timeline);

/// The same with a marking for each submission. Every marking must outlive the call.
std::vector<Graded> grade_each(std::vector<Submission> submissions, const std::vector<const Marking*>& markings,
                               const Runner& runner, int jobs, Timeline& timeline);

}  // namespace harness
