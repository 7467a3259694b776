// Why the reading of answers is doubtful, in words.
#pragma once

#include <string>

#include "harness/mark/score/score.h"

namespace harness {

/// Whom a sentence is for. A student is never told which number is right.
enum class Audience { student, instructor };

/// A sentence on each doubt. For an instructor it has the reason: "6.t: the right value stands on line 12, read
/// as 8.t". A student is told of the doubts that do not depend on the key. Empty if there is no doubt.
std::string doubts_text(const Score& score, Audience audience);

}  // namespace harness
