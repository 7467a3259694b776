// Decisions that the roundings of a right float program may turn: a ray that grazes the sphere, a hit on the triangle's
// edge, two hits at the same t. The key decides them exactly; a right program need not agree.
#pragma once

#include <vector>

#include "harness/follow.h"
#include "harness/own_verdict.h"

namespace harness {

/// Whether a right program may print this for the sphere's t or the triangle's hit point, which are not there when the
/// ray misses, and the student's own right values leave it open too. Always false for other items. A point that the ray
/// misses the triangle in may be printed or left out ("no hit"): both are right.
bool is_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance);

/// Whether the printed value follows from close calls that went the other way, all the student's values it follows from
/// being right.
bool follows_from_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance);

/// Every verdict that a right program may come to.
std::vector<reference::Verdict> close_verdicts(const Evidence& evidence);

}  // namespace harness
