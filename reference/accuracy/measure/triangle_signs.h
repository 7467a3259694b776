// The signs that decide about a ray and a triangle.
#pragma once

#include "reference/accuracy/measure/signs.h"
#include "reference/stages/triangle.h"

namespace reference::accuracy {

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
