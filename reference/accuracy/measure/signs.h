// The signs that decide what a ray hits, with their objects. Each kind of object has, over any scalar S: add_signs,
// which adds the signs that are needed, and hit_where, t of the true hit in S's numbers. The cylinder's are in
// cylinder_signs.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/numbers/certified.h"
#include "reference/numbers/interval.h"
#include "reference/stages/sphere.h"
#include "reference/stages/triangle.h"

namespace reference::accuracy {

template <class S>
struct Sign {
    std::string what;
    std::string asks;
    std::partial_ordering sign;
    std::optional<S> value;  ///< empty for an order
};
template <class S>
using Signs = std::vector<Sign<S>>;

template <class S>
void add_signs(Signs<S>& signs, const std::string& name, const SphereAnswers<S>& sphere,
               const SphereAnswers<Certified>& true_sphere, const SphereAnswers<Interval<float>>& /*in_float*/,
               Boundary /*boundary*/) {
    const Quadratic<S>& quadratic = sphere.quadratic;
    const Quadratic<Certified>& truth = true_sphere.quadratic;
    const auto add = [&](const char* letter, const std::string& asks, const S& value) {
        signs.push_back({name + ": " + letter, asks, sign_of(value), value});
    };
    add("d", "whether the ray's line meets the " + name, quadratic.d);
    if (sign_of(truth.d) < 0) return;
    add("c", "whether the ray starts outside the " + name, quadratic.c);
    if (sign_of(truth.c) < 0) return;
    add("b", "whether the " + name + " lies ahead of the ray's start", quadratic.b);
}

template <class S>
std::optional<HitParameter<S>> hit_where(const SphereAnswers<S>& sphere, const SphereAnswers<Certified>& truth,
                                         Boundary /*boundary*/) {
    if (!truth.t) return std::nullopt;
    return QuadraticRoot<S>{sphere.quadratic, truth.choice};
}

template <class S>
void add_signs(Signs<S>& signs, const std::string& name, const TriangleAnswers<S>& triangle,
               const TriangleAnswers<Certified>& true_triangle, const TriangleAnswers<Interval<float>>& in_float,
               Boundary /*boundary*/) {
    const CramerSolution<S>& solution = triangle.solution;
    const CramerSolution<Certified>& truth = true_triangle.solution;
    // One of its signs makes it a miss in any float arithmetic.
    const bool surely_missed = in_float.classification == TriangleHit::miss;
    const auto det = sign_of(solution.det);
    const auto add = [&](const char* letter, const std::string& asks, const S& numerator,
                         const Certified& true_numerator) {
        const bool makes_the_miss = (sign_of(true_numerator) < 0) != (sign_of(truth.det) < 0);
        if (surely_missed && !makes_the_miss) return;
        const S upright = det < 0 ? S(-numerator) : numerator;
        const bool is_known = det < 0 || det > 0;
        signs.push_back({name + ": " + letter, asks, is_known ? sign_of(upright) : std::partial_ordering::unordered,
                         is_known ? std::optional<S>(numerator / solution.det) : std::nullopt});
    };
    if (!surely_missed)
        signs.push_back({name + ": det", "whether the ray is parallel to the " + name + "'s plane", det, solution.det});
    if (sign_of(truth.det) == 0) {
        signs.push_back({name + ": start", "whether the ray starts in the " + name + "'s plane",
                         sign_of(solution.t_numerator), solution.t_numerator});
        return;
    }
    add("t", "whether the " + name + " lies ahead of the ray's start", solution.t_numerator, truth.t_numerator);
    add("u", "on which side of the edge from A to C the ray passes", solution.u_numerator, truth.u_numerator);
    add("v", "on which side of the edge from A to B the ray passes", solution.v_numerator, truth.v_numerator);
    add("1 - u - v", "on which side of the edge from B to C the ray passes",
        solution.det - solution.u_numerator - solution.v_numerator, truth.det - truth.u_numerator - truth.v_numerator);
}

template <class S>
std::optional<HitParameter<S>> hit_where(const TriangleAnswers<S>& triangle, const TriangleAnswers<Certified>& truth,
                                         Boundary boundary) {
    if (!hit_distance(truth, boundary)) return std::nullopt;
    return fraction_of(triangle.solution);
}

}  // namespace reference::accuracy
