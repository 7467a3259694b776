// Shared by the files with the derivations of one part of the scene; only for them and derivations.cpp.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "harness/mark/compare/first_hit.h"
#include "harness/mark/diagnose/rules.h"

namespace harness::derivations {

using reference::Subject;
using Form = QuadraticForm;

/// The derivations of a part of the scene; each part's file defines its own.
template <Subject part>
const std::vector<Derivation>& of();
template <>
const std::vector<Derivation>& of<Subject::camera>();
template <>
const std::vector<Derivation>& of<Subject::sphere>();
template <>
const std::vector<Derivation>& of<Subject::triangle>();
template <>
const std::vector<Derivation>& of<Subject::cylinder>();

/// The object's items that rounding may decide in a correct program (see close_call.h).
template <Subject object>
std::vector<ItemId> close_calls_of();
template <>
std::vector<ItemId> close_calls_of<Subject::sphere>();
template <>
std::vector<ItemId> close_calls_of<Subject::triangle>();
template <>
std::vector<ItemId> close_calls_of<Subject::cylinder>();

// A vector of length 0 or axes in one plane give trivial results; a program earns no points for printing zeros. A value
// counts as 0 if its digits allow 0.
inline bool may_be_zero(const Interval& x) {
    return x.contains(0.0);
}
inline bool may_be_zero(const Vec& p) {
    return may_be_zero(p.x) && may_be_zero(p.y) && may_be_zero(p.z);
}

/// V; empty if its length may be 0.
inline std::optional<Vec> direction_of(const ItemTargets& known) {
    const auto direction = known.vector(item::V);
    if (!direction || may_be_zero(*direction)) return std::nullopt;
    return direction;
}

/// S + tV.
inline Targets point_from_t(const ItemTargets& known, const ItemId& t) {
    const auto parameter = known.scalar(t);
    if (!parameter) return {no_value()};
    return from([&](const auto& p, const auto& direction) { return reference::point_on_ray(p, direction, *parameter); },
                known.vector(item::P_WCS), direction_of(known));
}

/// S + tV for the first hit. If t is negative, "no hit" follows too.
inline Targets hit_from_t(const ItemTargets& known, const ItemId& t) {
    Targets targets = point_from_t(known, t);
    const auto parameter = known.scalar(t);
    if (parameter && sign_of(*parameter) < 0) targets.push_back(no_value());
    return targets;
}

// Quadratics of any object.

/// d from a, b and c; empty if both of its terms may be zero.
Targets discriminant(const ItemTargets& known, reference::Subject object, Form form);

/// The student's quadratic: c is computed from a, b and d, because the student computed the roots from these three.
/// Empty if a may be zero.
std::optional<reference::Quadratic<Interval>> quadratic_from_abd(const ItemTargets& known, reference::Subject object,
                                                                 Form form);

/// The handout's quadratic as a program in `form` writes it.
reference::Quadratic<Interval> in_form(reference::Quadratic<Interval> quadratic, Form form);

/// The handout's quadratic with these roots, a > 0, from one in `form`.
reference::Quadratic<Interval> in_full_form(reference::Quadratic<Interval> quadratic, Form form);

/// The hit root of a quadratic with these coefficients in `form`; several roots if rounding leaves a sign open.
Targets roots_of(const reference::Quadratic<Interval>& given, const IntervalScene& scene, Form form);

}  // namespace harness::derivations
