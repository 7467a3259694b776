// Intake for the command line.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "harness/submission.h"

namespace harness {

/// A mistake in the command line: what() says which path and the way out.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The submissions of the paths given, in their order. A path that can't be read or holds no submission throws
/// UsageError.
std::vector<Submission> find_submissions(const std::vector<std::filesystem::path>& paths);

}  // namespace harness
