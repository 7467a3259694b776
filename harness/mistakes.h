// What the files with the named mistakes share; for misconception.cpp and them alone.
#pragma once

#include <optional>
#include <vector>

#include "harness/misconception.h"

namespace harness::mistakes {

using Targets = std::vector<Target>;
using Vec = reference::Vec3<Real>;

const std::vector<Misconception>& of_camera();
const std::vector<Misconception>& of_sphere();
const std::vector<Misconception>& of_triangle();

/// compute(inputs...), when every input is there.
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

/// start + sign * t * V, a hit point with one of its inputs changed.
inline Targets point_with(const Known& known, const ItemId& t, const std::optional<Vec>& start, int sign) {
    return from([&](const Vec& p, const Vec& direction,
                    const Real& s) { return reference::point_on_ray(p, direction, Real(sign) * s); },
                start, known.vector({5, "V"}), known.scalar(t));
}

}  // namespace harness::mistakes
