// Questions 8 and 9 of the handout: the triangle. The ray is P = S + tV with S = P_WCS.
#pragma once

#include <string_view>

#include "reference/stages/camera.h"
#include "reference/stages/item_values.h"
#include "reference/stages/order.h"

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

/// The solution by Cramer's rule, with numerators and denominator separate: t = t_numerator / det, and so on. det = 0
/// if the ray is parallel to the triangle's plane or the triangle has no area.
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

/// The triangle's t.
template <class S>
Fraction<S> fraction_of(const CramerSolution<S>& solution) {
    return {solution.t_numerator, solution.det};
}

/// How the ray meets the triangle. Edges and vertices belong to the triangle.
enum class TriangleHit {
    hit,       ///< t > 0, u >= 0, v >= 0, u + v <= 1
    boundary,  ///< the same with t = 0 exactly: a hit or a miss, depending on the boundary policy
    miss,
    parallel,  ///< det = 0: the ray is parallel to the triangle's plane and outside it; t, u and v do not exist
    coplanar,  ///< det = 0 and the ray lies in the plane; t, u and v do not exist
    unsure,    ///< a sign is unknown (see sign_of)
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

/// Questions 8 and 9. t, u, v and hit solve the linear system, inside the triangle or not; empty if there is no
/// solution.
template <class S>
struct TriangleAnswers {
    LinearSystem<S> system;
    CramerSolution<S> solution;
    TriangleHit classification;
    std::optional<S> t;
    std::optional<S> u;
    std::optional<S> v;
    std::optional<Vec3<S>> hit;
    Vec3<S> normal;
};

template <class S>
TriangleAnswers<S> answer_object(const CameraAnswers<S>& ray, const Triangle<S>& triangle, Boundary /*boundary*/) {
    const LinearSystem<S> system = triangle_system(ray.P_WCS, ray.V, triangle);
    const CramerSolution<S> solution = solve_by_cramer(system);
    TriangleAnswers<S> answers{system, solution, classify(solution), {}, {}, {}, {}, triangle_normal(triangle)};
    const auto det = sign_of(solution.det);
    if (det < 0 || det > 0) {
        answers.t = solution.t_numerator / solution.det;
        answers.u = solution.u_numerator / solution.det;
        answers.v = solution.v_numerator / solution.det;
        answers.hit = point_on_ray(ray.P_WCS, ray.V, *answers.t);
    }
    return answers;
}

/// The triangle's t among the hits: empty if the ray does not hit it.
template <class S>
std::optional<S> hit_distance(const TriangleAnswers<S>& answers, Boundary boundary) {
    const bool at_start = answers.classification == TriangleHit::boundary && boundary == Boundary::nonnegative;
    if (answers.classification == TriangleHit::hit || at_start) return answers.t;
    return std::nullopt;
}

template <class S>
bool is_unsure(const TriangleAnswers<S>& triangle) {
    return triangle.classification == TriangleHit::unsure;
}

template <class S>
std::optional<HitParameter<S>> hit_parameter(const TriangleAnswers<S>& triangle, Boundary boundary) {
    if (!hit_distance(triangle, boundary)) return std::nullopt;
    return fraction_of(triangle.solution);
}

/// hit, miss, boundary (t = 0), coplanar or unsure.
template <class S>
std::string_view decision(const TriangleAnswers<S>& triangle) {
    switch (triangle.classification) {
        case TriangleHit::hit: return "hit";
        case TriangleHit::boundary: return "boundary";
        case TriangleHit::miss: return "miss";
        case TriangleHit::parallel: return "miss";
        case TriangleHit::coplanar: return "coplanar";
        case TriangleHit::unsure: return "unsure";
    }
    return "";
}

/// With the boundary at t > 0, a triangle with t = 0 has t, u and v but no hit point.
template <class S>
void add_values(const TriangleAnswers<S>& triangle, Boundary boundary, ItemValues<S>& values) {
    const bool no_hit_at_start = triangle.classification == TriangleHit::boundary && !hit_distance(triangle, boundary);
    values[item::triangle::matrix] = components(triangle.system.matrix);
    values[item::triangle::rhs] = components(triangle.system.rhs);
    values[item::triangle::t] = present<S>(triangle.t);
    values[item::triangle::u] = present<S>(triangle.u);
    values[item::triangle::v] = present<S>(triangle.v);
    values[item::triangle::hit] = no_hit_at_start ? ItemValue<S>() : present<S>(triangle.hit);
    values[item::triangle::normal] = components(triangle.normal);
}

}  // namespace reference
