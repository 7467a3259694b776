// Question 10 judged by values of t, u and v that are known to some digits only.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "harness/closeness.h"
#include "reference/stages/first_hit.h"
#include "reference/stages/sphere.h"

namespace harness {

/// What decides which object is first. A t is empty where the ray does not hit the object; without u or v the point
/// counts as inside the triangle.
struct HitValues {
    std::optional<Real> sphere_t;
    std::optional<Real> triangle_t;
    std::optional<Real> u = {};
    std::optional<Real> v = {};
    /// How far a right program's t, u and v may be off: a student's test may forgive as much ("t >= -1e-6").
    double t_allowance = 0;
    double uv_allowance = 0;
};

enum class Hits { yes, maybe, no };

/// Whether the point is a true hit of the triangle: t > 0, or t >= 0, and inside.
Hits hits_triangle(const HitValues& values, reference::Boundary boundary);

/// Every verdict that a program with such values may print under one of `boundaries`.
std::vector<reference::Verdict> possible_verdicts(const HitValues& values,
                                                  std::span<const reference::Boundary> boundaries);

/// The handout's question 10 taken by its words alone: "the point with smaller t", without a look at its sign or at u
/// and v. Empty without both t, or where their digits leave it open.
std::optional<reference::Verdict> smaller_t(const HitValues& values);

}  // namespace harness
