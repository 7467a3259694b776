// Question 10 judged by the student's own values of t, u and v.
#pragma once

#include <vector>

#include "harness/match.h"
#include "reference/stages/first_hit.h"

namespace harness {

/// The student's items that decide which object is first; null where an item was not printed readably.
struct OwnHits {
    const MatchedItem* sphere_t;
    const MatchedItem* triangle_t;
    const MatchedItem* u;
    const MatchedItem* v;
};

/// Every verdict that agrees with the student's own values, t = 0 counting as a hit or not. Empty when they do not suffice.
std::vector<reference::Verdict> own_verdicts(const OwnHits& hits, int min_decimals);

}  // namespace harness
