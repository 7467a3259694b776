// Whether a program answers the same each time it is run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/execution/execution.h"
#include "harness/mark/score/score.h"

namespace harness {

/// One run of a program, read and marked.
struct Repetition {
    Ended ended = Ended::not_started;
    Score score;
};

/// A sentence about the difference between a later run and the first: in an item's answer, or in how it ended. Output
/// that belongs to no item, such as the time taken, may differ. Empty if all runs answer the same.
std::optional<std::string> difference(const std::vector<Repetition>& runs);

}  // namespace harness
