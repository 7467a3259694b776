// Why the reading of answers is doubtful, in words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/mark/score/score.h"

namespace harness {

/// Whom a sentence is for. A student is never told which number is right.
enum class Audience { student, instructor };

/// An item's name for people: "which object is hit first" for a verdict.
std::string_view name_in_words(std::string_view item);

/// Items by question and name, in the order of their questions: "question 6 (t, d) and question 8 (matrix)".
std::string items_in_words(const std::vector<std::pair<int, std::string>>& items);

/// A sentence on each doubt. For an instructor it has the reason: "question 6 (t): the right value is on line 12, read
/// as question 8 (t)". A student gets the doubts that do not depend on the key. Empty if there is no doubt.
std::string doubts_text(const Score& score, Audience audience);

}  // namespace harness
