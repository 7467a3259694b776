// Whether a program answers the same each time it is run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/execution.h"
#include "harness/score.h"

namespace harness {

/// One run of a program, read and marked.
struct Repetition {
    Ended ended = Ended::not_started;
    Score score;
};

/// How a later run differs from the first, as a sentence: the first item that was printed otherwise, or another end.
/// What belongs to no item, such as the time taken, may differ. Empty when all answer alike.
std::optional<std::string> difference(const std::vector<Repetition>& runs);

}  // namespace harness
