// Finds the answers of a ray that misses an object, in any question.
#pragma once

#include <functional>
#include <vector>

#include "harness/match/matched_item.h"
#include "harness/match/question_match.h"

namespace harness {

/// Reads "no hit" for the items of one question that have no finite number under their own name, unless it is about
/// another object. `candidates` are the question's printed values.
void take_denials(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, Fits& fits);

/// Whether anything is printed under the heading of the question with this number.
using IsAnswered = std::function<bool(int question)>;

/// "The ray misses the sphere", printed once, applies to the sphere's t, hit point and normal in all answered
/// questions, even if nan, inf or zeros are printed for them. "t = -1", "t = inf" and "t = 1e30" mean the same if no
/// other finite hit point or normal is printed.
void settle_misses(std::vector<MatchedItem>& matched, const IsAnswered& is_answered);

}  // namespace harness
