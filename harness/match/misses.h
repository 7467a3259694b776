// What is printed where the ray misses an object: words, nothing, or a record as a program sets it before it looks for
// a hit. Such items get a value without numbers.
#pragma once

#include <functional>
#include <vector>

#include "harness/match/matched_item.h"
#include "harness/match/question_match.h"

namespace harness {

/// Whether there is something under the question's heading, by its number.
using IsAnswered = std::function<bool(int question)>;

/// Settles the misses within one question; `candidates` are what was printed there.
void settle_misses(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, Fits& fits);

/// Settles what the answers to one question say of another's.
void settle_misses_between_questions(std::vector<MatchedItem>& matched, const IsAnswered& is_answered);

}  // namespace harness
