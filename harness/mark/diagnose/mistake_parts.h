// Shared by the files with the named mistakes; only for them and mistakes.cpp.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/mark/diagnose/rules.h"

namespace harness::mistakes {

using reference::Subject;

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

inline Targets just(const Vec& p) {
    return {target_of(p)};
}

inline Targets both(Targets targets, const Targets& other) {
    targets.insert(targets.end(), other.begin(), other.end());
    return targets;
}

/// start + sign * t * V: a hit point with a changed input.
inline Targets point_with(const ItemTargets& known, const ItemId& t, const std::optional<Vec>& start, int sign) {
    return from([&](const Vec& p, const Vec& direction,
                    const Interval& s) { return reference::point_on_ray(p, direction, Interval(sign) * s); },
                start, known.vector(item::V), known.scalar(t));
}

// Mistakes in a hit point S + tV, for the object with this t.
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

// Mistakes in a discriminant and in a root, for any quadratic's coefficients.
using Formula = Interval (*)(const Interval& p, const Interval& q, const Interval& r);

/// formula(a, b, c) of the object's quadratic.
template <Subject object, Formula formula>
Targets d_by(const ItemTargets& known, const IntervalScene&) {
    return from(formula, known.scalar({object, "a"}), known.scalar({object, "b"}), known.scalar({object, "c"}));
}
template <int factor>
Interval square_plus(const Interval& p, const Interval& q, const Interval& r) {
    return q * q + Interval(factor) * p * r;
}
inline Interval negated(const Interval& p, const Interval& q, const Interval& r) {
    return Interval(4) * p * r - q * q;
}

inline Interval smaller_root(const Interval& p, const Interval& q, const Interval& d) {
    return (-q - sqrt(d)) / (Interval(2) * p);
}
inline Interval larger_root(const Interval& p, const Interval& q, const Interval& d) {
    return (-q + sqrt(d)) / (Interval(2) * p);
}
inline Interval smaller_not_halved(const Interval& p, const Interval& q, const Interval& d) {
    return (-q - sqrt(d)) / p;
}
inline Interval larger_not_halved(const Interval& p, const Interval& q, const Interval& d) {
    return (-q + sqrt(d)) / p;
}
inline Interval without_square_root(const Interval& p, const Interval& q, const Interval& d) {
    return (-q - d) / (Interval(2) * p);
}
inline Interval smaller_of_minus_b(const Interval& p, const Interval& q, const Interval& d) {
    return smaller_root(p, -q, d);
}
inline Interval larger_of_minus_b(const Interval& p, const Interval& q, const Interval& d) {
    return larger_root(p, -q, d);
}
inline Interval halved_times_a(const Interval& p, const Interval& q, const Interval& d) {
    return (-q - sqrt(d)) / Interval(2) * p;
}
inline Interval only_root_divided(const Interval& p, const Interval& q, const Interval& d) {
    return -q - sqrt(d) / (Interval(2) * p);
}
inline Interval only_root_halved_times_a(const Interval& p, const Interval& q, const Interval& d) {
    return -q - sqrt(d) / Interval(2) * p;
}

inline constexpr std::string_view transposed_advice =
    "The matrix is transposed when it is built or printed: GLM's constructors take columns, and m[0] is the "
    "first column.";
inline constexpr std::string_view starts_at_eye = "The ray P = S + tV starts at the pixel, S = P_WCS, not at the eye.";

}  // namespace harness::mistakes
