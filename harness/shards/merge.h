// Makes a class of its parts.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/gradebook/gradebook.h"
#include "harness/record/marking.h"
#include "harness/shards/part.h"

namespace harness {

/// Reads the parts and puts the class together, in the order in which it was taken in; `head` is the first part's.
/// Throws UsageError, which names all parts that are missing, double, damaged or of a different grading.
Part merge_parts(const std::vector<std::filesystem::path>& files);

/// What the lists of students and the gradebook need to know of the submissions, in the order of the class.
std::vector<Submission> submissions_of(const Part& merged);

/// Takes the submissions' results out of a merged class, in the order of `submissions`, which have the names and
/// rereads that hold now. Where those are not the rereads that a result was marked with, its printout is marked again.
std::vector<Graded> results_of(std::vector<Submission> submissions, Part& merged, const Marking& marking);

}  // namespace harness
