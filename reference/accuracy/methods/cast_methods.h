// Question 10 as programs answer it: intersect each object on its own, then take the smaller t.
#pragma once

#include <array>

#include "reference/accuracy/methods/method.h"
#include "reference/accuracy/methods/sphere_methods.h"
#include "reference/accuracy/methods/triangle_methods.h"
#include "reference/kernel/first.h"

namespace reference::accuracy {

/// The textbook's quadratic and Cramer's rule; t is compared as computed.
template <class S>
FirstHit<S> naive_cast(const Ray<S>& ray, const Sphere<S>& sphere, const Triangle<S>& triangle) {
    const Hit<S> round = naive_quadratic(ray, sphere);
    const Hit<S> flat = cramer(ray, triangle);
    if (!round.hit && !flat.hit) return {};
    if (!flat.hit) return {Outcome::sphere_first, round.t};
    if (!round.hit) return {Outcome::triangle_first, flat.t};
    if (round.t == flat.t) return {Outcome::tie, round.t};
    return round.t < flat.t ? FirstHit<S>{Outcome::sphere_first, round.t}
                            : FirstHit<S>{Outcome::triangle_first, flat.t};
}

/// Both without a branch, and the nearer hit chosen by index.
template <class S>
FirstHit<S> branch_free_cast(const Ray<S>& ray, const Sphere<S>& sphere, const Triangle<S>& triangle) {
    const Hit<S> round = half_b_branch_free(ray, sphere);
    const Hit<S> flat = cramer_branch_free(ray, triangle);
    const int nearer = static_cast<int>(round.t < flat.t);
    const int tie = static_cast<int>(round.t == flat.t);
    const int both = static_cast<int>(round.hit) & static_cast<int>(flat.hit);
    const int round_first = static_cast<int>(round.hit) & ((1 - static_cast<int>(flat.hit)) | nearer);
    constexpr std::array outcomes{Outcome::miss,         Outcome::triangle_first,
                                  Outcome::sphere_first, Outcome::sphere_first,
                                  Outcome::tie,          Outcome::tie,
                                  Outcome::tie,          Outcome::tie};
    const std::array ts{flat.t, round.t};
    return {outcomes[static_cast<std::size_t>(4 * (both & tie) + 2 * round_first + static_cast<int>(flat.hit))],
            ts[static_cast<std::size_t>(round_first)]};
}

inline Outcome outcome_of(kernel::FirstHit::Kind first) {
    switch (first) {
        case kernel::FirstHit::Kind::sphere: return Outcome::sphere_first;
        case kernel::FirstHit::Kind::triangle: return Outcome::triangle_first;
        case kernel::FirstHit::Kind::tie: return Outcome::tie;
        case kernel::FirstHit::Kind::none:
        case kernel::FirstHit::Kind::invalid: break;
    }
    return Outcome::miss;
}

/// The certified kernel's first object, with its t to the accuracy of a float.
inline FirstHit<double> certified_cast(const OrderCase& c) {
    const kernel::FirstHit found = kernel::first_of(c.ray, c.sphere, c.triangle);
    return {outcome_of(found.kind), found.t};
}

}  // namespace reference::accuracy
