// Grades a class with the main path of grade_submission.h, and schedules compiling and running so that no core waits.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "harness/grade/grade_submission.h"

namespace harness {

/// Grades a class: at most `jobs` (at least 1) submissions are compiled and as many run at a time. The results are in
/// the order given; they do not depend on the number of jobs, the order of finishing or the cache's contents. A failure
/// of the machine or of raygrade makes that submission not_graded, and the others continue. `timeline` is filled
/// meanwhile. If students have their own scenes, each submission is checked against its student's.
std::vector<Graded> grade_all(std::vector<Submission> submissions, const Marking& marking, const Runner& runner,
                              int jobs, Timeline& timeline);

/// Same with a marking for each submission. Every marking must outlive the call.
std::vector<Graded> grade_each(std::vector<Submission> submissions, const std::vector<const Marking*>& markings,
                               const Runner& runner, int jobs, Timeline& timeline);

/// The next step of a submission once it is compiled. `run` runs it, and rethrows exceptions of compiling and running.
/// It must be called at most once, and not for a submission with a problem.
using WhenCompiled =
    std::function<void(std::size_t index, const Submission& submission, const std::function<Executions()>& run)>;

/// Compiles the submissions as grade_all does, and calls `then` for each, from several threads and in any order. `then`
/// must not throw, and counts its finished submissions in the timeline.
void run_each(std::vector<Submission> submissions, const Runner& runner, int jobs, Timeline& timeline,
              const WhenCompiled& then);

/// Adds to the timeline's counts of how submissions were compiled.
void count_ways(const Executions& executions, std::size_t submissions, Timeline& timeline);

}  // namespace harness
