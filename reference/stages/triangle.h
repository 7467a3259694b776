// Questions 8 and 9 of the handout: the triangle. The ray is P = S + tV with S = P_WCS.
#pragma once

#include "reference/stages/sphere.h"

namespace reference {

/// Question 8: A + u(B-A) + v(C-A) = S + tV as `matrix` * (t, u, v) = `rhs`. The matrix has the columns -V, B-A, C-A.
template <class S>
struct LinearSystem {
    Mat3<S> matrix;
    Vec3<S> rhs;
};

template <class S>
LinearSystem<S> triangle_system(const Vec3<S>& start, const Vec3<S>& V, const Triangle<S>& triangle) {
    return {Mat3<S>(scaled(V, S(-1)), triangle.B - triangle.A, triangle.C - triangle.A), start - triangle.A};
}

/// The solution by Cramer's rule, numerators and denominator kept apart: t = t_numerator / det, and so on.
/// det = 0 where the ray is parallel to the triangle's plane or the triangle has no area.
template <class S>
struct CramerSolution {
    S det;
    S t_numerator;
    S u_numerator;
    S v_numerator;
};

template <class S>
CramerSolution<S> solve_by_cramer(const LinearSystem<S>& system) {
    const Vec3<S>& p = system.matrix[0];
    const Vec3<S>& q = system.matrix[1];
    const Vec3<S>& r = system.matrix[2];
    const Vec3<S> q_r = cross(q, r);
    const Vec3<S> p_rhs = cross(p, system.rhs);
    return {dot(p, q_r), dot(system.rhs, q_r), dot(p_rhs, r), S(-dot(p_rhs, q))};
}

/// How the ray meets the triangle. Edges and vertices belong to the triangle.
enum class TriangleHit {
    hit,       ///< t > 0, u >= 0, v >= 0, u + v <= 1
    boundary,  ///< the same with t = 0 exactly: a hit or a miss as the boundary policy says
    miss,
    parallel,  ///< det = 0: the ray is parallel to the triangle's plane and outside it; t, u and v do not exist
    coplanar,  ///< det = 0 and the ray lies in the plane; t, u and v do not exist
    unsure,    ///< a sign could not be told (see sign_of)
};

template <class S>
TriangleHit classify(const CramerSolution<S>& solution) {
    const auto det = sign_of(solution.det);
    if (det == std::partial_ordering::unordered) return TriangleHit::unsure;
    if (det == 0) {
        const auto start = sign_of(solution.t_numerator);
        if (start == std::partial_ordering::unordered) return TriangleHit::unsure;
        return start == 0 ? TriangleHit::coplanar : TriangleHit::parallel;
    }
    const auto towards = [&](const S& numerator) { return sign_of(det < 0 ? S(-numerator) : S(numerator)); };
    const auto u = towards(solution.u_numerator);
    const auto v = towards(solution.v_numerator);
    const auto w = towards(solution.det - solution.u_numerator - solution.v_numerator);
    const auto t = towards(solution.t_numerator);
    if (u < 0 || v < 0 || w < 0 || t < 0) return TriangleHit::miss;
    const auto unknown = std::partial_ordering::unordered;
    if (u == unknown || v == unknown || w == unknown || t == unknown) return TriangleHit::unsure;
    return t > 0 ? TriangleHit::hit : TriangleHit::boundary;
}

/// Question 9: the unit normal (B-A) x (C-A).
template <class S>
Vec3<S> triangle_normal(const Triangle<S>& triangle) {
    return normalized(cross(Vec3<S>(triangle.B - triangle.A), Vec3<S>(triangle.C - triangle.A)));
}

}  // namespace reference
