// Shared by the files with the named mistakes; only for them and mistakes.cpp.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/mark/diagnose/mistake.h"

namespace harness::mistakes {

using reference::Subject;
using Targets = std::vector<Target>;
using Vec = reference::Vec3<Interval>;

/// The mistakes of a part of the scene; each part's file defines its own.
template <Subject part>
const std::vector<Mistake>& of();
template <>
const std::vector<Mistake>& of<Subject::camera>();
template <>
const std::vector<Mistake>& of<Subject::sphere>();
template <>
const std::vector<Mistake>& of<Subject::triangle>();
template <>
const std::vector<Mistake>& of<Subject::cylinder>();

/// compute(inputs...); empty if an input is missing.
template <class... Inputs>
Targets from(auto compute, const std::optional<Inputs>&... inputs) {
    if (!(inputs && ...)) return {};
    return {target_of(compute(*inputs...))};
}

inline Targets just(const Vec& p) {
    return {target_of(p)};
}

inline Targets both(Targets one, const Targets& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

/// start + sign * t * V: a hit point with a changed input.
inline Targets point_with(const ItemTargets& known, const ItemId& t, const std::optional<Vec>& start, int sign) {
    return from([&](const Vec& p, const Vec& direction,
                    const Interval& s) { return reference::point_on_ray(p, direction, Interval(sign) * s); },
                start, known.vector(item::V), known.scalar(t));
}

// Mistakes in a hit point S + tV, of whichever object has this t.
template <const ItemId& t>
Targets hit_from_eye(const ItemTargets& known, const IntervalScene& scene) {
    return point_with(known, t, scene.camera.eye, 1);
}
template <const ItemId& t>
Targets hit_without_start(const ItemTargets& known, const IntervalScene&) {
    return point_with(known, t, Vec(Interval(0.0)), 1);
}
template <const ItemId& t>
Targets hit_backward(const ItemTargets& known, const IntervalScene&) {
    return point_with(known, t, known.vector(item::P_WCS), -1);
}

inline constexpr std::string_view transposed_advice =
    "The matrix is transposed, built or printed the wrong way round: GLM's constructors take columns, and m[0] is the "
    "first column.";
inline constexpr std::string_view starts_at_eye = "The ray P = S + tV starts at the pixel, S = P_WCS, not at the eye.";

}  // namespace harness::mistakes
