// Judges which object is hit first, from values of t, u and v that are known only to some digits.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "harness/mark/compare/closeness.h"
#include "reference/stages/first_hit.h"
#include "reference/stages/sphere.h"

namespace harness {

/// The values that decide which object is first. Without u or v, the point counts as inside the triangle.
struct HitValues {
    /// One for each kind of object in the scene; empty if the ray does not hit it.
    std::map<reference::Subject, std::optional<Interval>> t;
    std::optional<Interval> u = {};
    std::optional<Interval> v = {};
    /// How far a correct program's t, u and v may be off. A student's test may tolerate as much ("t >= -1e-6").
    double t_allowance = 0;
    double uv_allowance = 0;
};

enum class Hits { yes, maybe, no };

/// Whether the point is a true hit of the triangle: inside, with t > 0 or t >= 0 as `boundary` says.
Hits hits_triangle(const HitValues& values, reference::Boundary boundary);

/// Every first object that a program with these values may print under any of `boundaries`.
std::vector<reference::FirstObject> possible_first_objects(const HitValues& values,
                                                           std::span<const reference::Boundary> boundaries);

/// Answers by the handout's words alone, "the point with smaller t", and ignores the sign of t, u and v. Empty if a t
/// is missing or the digits do not decide the order.
std::optional<reference::FirstObject> smaller_t(const HitValues& values);

}  // namespace harness
