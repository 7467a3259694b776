// A method's result for one ray, and the truth.
#pragma once

#include <cstdint>

#include "reference/kernel/ray.h"

namespace reference::accuracy {

using kernel::Ray;

/// t is meaningless for a miss.
template <class S>
struct Hit {
    bool hit = false;
    S t{};
};

/// For one object: miss or hit. For a scene: miss, or the object that the ray hits first.
enum class Outcome : std::uint8_t { miss, hit, sphere_first, triangle_first, tie };

/// t of the object that the ray hits first.
template <class S>
struct FirstHit {
    Outcome outcome = Outcome::miss;
    S t{};
};

/// A method's result, or the truth, in one type for all: t is an unevaluated sum of two doubles, 106 bits, so that even
/// a double's error is visible. A hit whose t is not finite counts as a miss.
struct Answer {
    Outcome outcome = Outcome::miss;
    double t = 0;
    double t_rest = 0;
};

/// The closed policy of all methods: the smaller root that is at least 0. near <= far. NaN is never a hit.
template <class S>
Hit<S> first_root(const S& near, const S& far) {
    if (near >= 0) return {true, near};
    if (far >= 0) return {true, far};
    return {};
}

}  // namespace reference::accuracy
