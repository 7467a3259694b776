// The main path for a class: what is to be compiled when, so that no core waits.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness {

/// Grades a class: at most `jobs` (at least 1) submissions compiled and as many run at a time. Results in the order
/// given and the same whatever the number of jobs, the order of finishing, and what was kept by earlier runs. The
/// machine's failures and raygrade's own become Outcome::not_graded with the message, so that the others are graded.
/// `timeline` counts and measures while it works. The marking is waited for when the first program has run; without one
/// nothing is graded, and this throws what it throws.
std::vector<Graded> grade_all(std::vector<Submission> submissions, const std::shared_future<Marking>& marking,
                              const Workshop& workshop, int jobs, Timeline& timeline);

/// The same, each submission held to a marking of its own; as many markings as submissions.
std::vector<Graded> grade_each(std::vector<Submission> submissions, std::vector<std::shared_future<Marking>> markings,
                               const Workshop& workshop, int jobs, Timeline& timeline);

/// What is said of a fault of raygrade's own.
std::string fault_sentence(const std::exception& error);

/// Grades one submission.
Graded grade(const Submission& submission, const std::shared_future<Marking>& marking, const Workshop& workshop);

}  // namespace harness
