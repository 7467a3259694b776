// Close calls: decisions that rounding may flip in a correct float program, such as a ray that grazes the sphere, a hit
// on the triangle's edge, or two hits at the same t. The key decides them exactly; a correct program need not agree.
#pragma once

#include <vector>

#include "harness/mark/compare/first_hit.h"
#include "harness/mark/diagnose/follow.h"

namespace harness {

/// Whether a correct program may print this for one of close_call_items() and the student's own right values leave it
/// open too. Examples: a t or a hit point, which does not exist if the ray misses, or a normal, which differs on each
/// side of a rim. Always false for other items. A miss of the sphere only needs a discriminant that may be negative in
/// float. If the ray meets the triangle's plane outside the triangle, the point may be printed or left out ("no hit"):
/// both are right.
bool is_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance);

/// Whether the printed value follows from close calls that went the other way. All of the student's values that it
/// follows from must be right.
bool follows_from_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance);

/// Every first object that a correct program may print.
std::vector<reference::FirstObject> close_first_objects(const Evidence& evidence);

}  // namespace harness
