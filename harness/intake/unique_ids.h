// Gives submissions of several folders ids that differ.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/intake/submission.h"

namespace harness {

/// A submission, and the path where it was found.
struct Taken {
    std::filesystem::path from;
    std::string id;  ///< the submission's id there
    Submission submission;
};

/// The submissions in their order. Equal ids get as many folder names of their paths in front as they need to differ
/// (2020-s01, 2021-s01), or else a number at the end.
std::vector<Submission> with_unique_ids(std::vector<Taken> all);

}  // namespace harness
