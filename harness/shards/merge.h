// Merges a class from its parts.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/gradebook/gradebook.h"
#include "harness/record/marking.h"
#include "harness/shards/part.h"

namespace harness {

/// Reads the parts and merges the class in its intake order; `head` is the first part's. Throws UsageError, whose
/// message names all parts that are missing, duplicate, damaged or from a different grading.
Part merge_parts(const std::vector<std::filesystem::path>& files);

/// The submissions, in the order of the class, with the data that the lists of students and the gradebook need.
std::vector<Submission> submissions_of(const Part& merged);

/// Moves the results out of a merged class, in the order of `submissions`, which have the current names and rereads. If
/// a result was marked with different rereads, its printout is marked again.
std::vector<Graded> results_of(std::vector<Submission> submissions, Part& merged, const Marking& marking);

}  // namespace harness
