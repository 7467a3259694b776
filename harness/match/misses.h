// What answers say of each other where the ray misses an object.
#pragma once

#include <functional>
#include <vector>

#include "harness/match/matched_item.h"
#include "harness/match/question_match.h"

namespace harness {

/// Reads "no hit", said in the question and not of another object, for the items of one question that have no finite
/// number under their own name. `candidates` are what was printed there.
void take_denials(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, Fits& fits);

/// Whether there is something under the question's heading, by its number.
using IsAnswered = std::function<bool(int question)>;

/// "The ray misses the sphere", said once, holds for its t, its hit point and its normal alike, also where nan, inf
/// or zeros are printed for them, in all questions that were answered. "t = -1", "t = inf" and "t = 1e30" say so if no
/// other finite hit point or normal is printed.
void settle_misses(std::vector<MatchedItem>& matched, const IsAnswered& is_answered);

}  // namespace harness
