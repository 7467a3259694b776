// Shared by the files with the named mistakes; only for them and mistakes.cpp.
#pragma once

#include <optional>
#include <vector>

#include "harness/mark/diagnose/mistakes.h"

namespace harness::mistakes {

using Targets = std::vector<Target>;
using Vec = reference::Vec3<Interval>;

const std::vector<Mistake>& of_camera();
const std::vector<Mistake>& of_sphere();
const std::vector<Mistake>& of_triangle();

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

}  // namespace harness::mistakes
