// The doubts about the reading of answers, in words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/mark/score/score.h"

namespace harness {

/// The reader of a sentence. A sentence for a student never says which number is right.
enum class Audience { student, instructor };

/// An item's name for people: "which object is hit first" for a verdict.
std::string_view name_in_words(std::string_view item);

/// Items by question and name, in the order of their questions: "question 6 (t, d) and question 8 (matrix)".
std::string items_in_words(const std::vector<std::pair<int, std::string>>& items);

/// One sentence per doubt. For an instructor, it includes the reason: "question 6 (t): the right value is on line 12,
/// read as question 8 (t)". A student sees only doubts that do not depend on the key. Empty if there is no doubt.
std::string doubts_text(const Score& score, Audience audience);

}  // namespace harness
