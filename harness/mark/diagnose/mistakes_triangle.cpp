// The named mistakes of the triangle.
#include "harness/mark/diagnose/mistake_parts.h"

namespace harness::mistakes {
namespace triangle_mistakes {
namespace {

using reference::cross;
using reference::normalized;
using Matrix = reference::Mat3<Interval>;
using Solved = reference::CramerSolution<Interval>;

using item::P_WCS, item::V;
using namespace item::triangle;

const reference::Triangle<Interval>& triangle(const IntervalScene& scene) {
    return scene.triangles.front();
}
Vec edge1(const IntervalScene& scene) {
    return triangle(scene).B - triangle(scene).A;
}
Vec edge2(const IntervalScene& scene) {
    return triangle(scene).C - triangle(scene).A;
}

Targets system_with(const ItemTargets& known, auto columns) {
    return from([&](const Vec& direction) { return columns(direction); }, known.vector(V));
}
Targets v_not_negated(const ItemTargets& known, const IntervalScene& scene) {
    return system_with(known, [&](const Vec& direction) { return Matrix(direction, edge1(scene), edge2(scene)); });
}
Targets edges_reversed(const ItemTargets& known, const IntervalScene& scene) {
    return system_with(known, [&](const Vec& direction) { return Matrix(-direction, -edge1(scene), -edge2(scene)); });
}
Targets vertices_for_edges(const ItemTargets& known, const IntervalScene& scene) {
    return system_with(known,
                       [&](const Vec& direction) { return Matrix(-direction, triangle(scene).B, triangle(scene).C); });
}
Targets transposed_system(const ItemTargets& known, const IntervalScene& scene) {
    return system_with(known, [&](const Vec& direction) {
        const Matrix m(-direction, edge1(scene), edge2(scene));
        return Matrix(Vec(m[0][0], m[1][0], m[2][0]), Vec(m[0][1], m[1][1], m[2][1]), Vec(m[0][2], m[1][2], m[2][2]));
    });
}

Targets rhs_reversed(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return Vec(triangle(scene).A - p); }, known.vector(P_WCS));
}
Targets rhs_from_eye(const ItemTargets&, const IntervalScene& scene) {
    return just(Vec(scene.camera.eye - triangle(scene).A));
}
Targets rhs_without_a(const ItemTargets& known, const IntervalScene&) {
    return from([](const Vec& p) { return p; }, known.vector(P_WCS));
}

/// The right solution for a ray from `start`; empty if there is none.
std::optional<Solved> solve(const ItemTargets& known, const IntervalScene& scene, const std::optional<Vec>& start) {
    const auto direction = known.vector(V);
    if (!start || !direction) return std::nullopt;
    const Solved solution = reference::solve_by_cramer(reference::triangle_system(*start, *direction, triangle(scene)));
    const auto det = sign_of(solution.det);
    return det < 0 || det > 0 ? std::optional(solution) : std::nullopt;
}
template <Interval Solved::*Numerator, int Sign = 1>
Targets unknown(const ItemTargets& known, const IntervalScene& scene) {
    return from([](const Solved& s) { return Interval(Sign) * s.*Numerator / s.det; },
                solve(known, scene, known.vector(P_WCS)));
}
template <Interval Solved::*Numerator>
Targets undivided(const ItemTargets& known, const IntervalScene& scene) {
    return from([](const Solved& s) { return s.*Numerator; }, solve(known, scene, known.vector(P_WCS)));
}
Targets weight_of_a(const ItemTargets& known, const IntervalScene& scene) {
    return from([](const Solved& s) { return Interval(1) - (s.u_numerator + s.v_numerator) / s.det; },
                solve(known, scene, known.vector(P_WCS)));
}
Targets t_from_eye(const ItemTargets& known, const IntervalScene& scene) {
    return from([](const Solved& s) { return s.t_numerator / s.det; }, solve(known, scene, scene.camera.eye));
}

Targets hit_without_a(const ItemTargets& known, const IntervalScene& scene) {
    return from(
        [&](const Interval& p, const Interval& q) {
            return Vec(reference::scaled(edge1(scene), p) + reference::scaled(edge2(scene), q));
        },
        known.scalar(u), known.scalar(v));
}

Targets n_order(const ItemTargets&, const IntervalScene& scene) {
    return just(normalized(cross(edge2(scene), edge1(scene))));
}
Targets n_long(const ItemTargets&, const IntervalScene& scene) {
    return just(cross(edge1(scene), edge2(scene)));
}
Targets n_order_and_long(const ItemTargets&, const IntervalScene& scene) {
    return just(cross(edge2(scene), edge1(scene)));
}
Targets n_of_vertices(const ItemTargets&, const IntervalScene& scene) {
    const auto& corners = triangle(scene);
    return {target_of(normalized(cross(corners.B, corners.C))), target_of(normalized(cross(corners.A, corners.B))),
            target_of(normalized(cross(corners.A, corners.C)))};
}

constexpr std::string_view check_columns =
    "This is the value of another unknown; check which column of the matrix belongs to which unknown.";
constexpr std::string_view wrong_side =
    "The sign does not match your matrix: S - A goes with (-V | B - A | C - A), and A - S to (V | A - B | A - C).";
constexpr std::string_view divide_by_det = "Cramer's rule divides by the determinant of the matrix.";

}  // namespace
}  // namespace triangle_mistakes

template <>
const std::vector<Mistake>& of<Subject::triangle>() {
    using namespace triangle_mistakes;
    static const std::vector<Mistake> table = {
        {"V not negated", "V changes sign when it moves to the side with u and v.", matrix, v_not_negated},
        {"edges the wrong way round", "The columns for u and v are B - A and C - A.", matrix, edges_reversed},
        {"vertices for edges", "The columns for u and v are the edges B - A and C - A, not the vertices.", matrix,
         vertices_for_edges},
        {"matrix transposed", transposed_advice, matrix, transposed_system},
        {"right-hand side negated", wrong_side, rhs, rhs_reversed},
        {"ray starts at the eye", "The ray starts at S = P_WCS, not at the eye.", rhs, rhs_from_eye},
        {"A forgotten", "The right-hand side is the difference of S and A; A is missing.", rhs, rhs_without_a},
        {"ray starts at the eye", starts_at_eye, t, t_from_eye},
        {"sign of t", "The sign of t is wrong; check the signs of V and of the right-hand side in the system.", t,
         unknown<&Solved::t_numerator, -1>},
        {"wrong unknown", check_columns, t, unknown<&Solved::u_numerator>},
        {"wrong unknown", check_columns, t, unknown<&Solved::v_numerator>},
        {"not divided by the determinant", divide_by_det, t, undivided<&Solved::t_numerator>},
        {"u and v swapped", "This is the value of v.", u, unknown<&Solved::v_numerator>},
        {"wrong unknown", check_columns, u, unknown<&Solved::t_numerator>},
        {"weight of A", "This is 1 - u - v, the weight of vertex A.", u, weight_of_a},
        {"sign of u", "The sign of u is wrong.", u, unknown<&Solved::u_numerator, -1>},
        {"not divided by the determinant", divide_by_det, u, undivided<&Solved::u_numerator>},
        {"u and v swapped", "This is the value of u.", v, unknown<&Solved::u_numerator>},
        {"wrong unknown", check_columns, v, unknown<&Solved::t_numerator>},
        {"weight of A", "This is 1 - u - v, the weight of vertex A.", v, weight_of_a},
        {"sign of v", "The sign of v is wrong.", v, unknown<&Solved::v_numerator, -1>},
        {"not divided by the determinant", divide_by_det, v, undivided<&Solved::v_numerator>},
        {"ray starts at the eye", "The hit point is S + tV with S = P_WCS, not the eye.", hit, hit_from_eye<t>},
        {"start forgotten", "The hit point is S + tV; S is missing.", hit, hit_without_start<t>},
        {"sign of t", "The hit point is S plus tV.", hit, hit_backward<t>},
        {"A forgotten", "The hit point is A + u(B-A) + v(C-A); A is missing.", hit, hit_without_a},
        {"opposite direction",
         "The normal points the opposite way: it is (B-A) x (C-A). Check the order and the signs of both edges.",
         normal, n_order},
        {"not normalized", "The normal must have length 1.", normal, n_long},
        {"opposite direction, not normalized",
         "The normal points the opposite way, and its length must be 1: it is (B-A) x (C-A), normalized. Check the "
         "order and the signs of both edges.",
         normal, n_order_and_long},
        {"vertices for edges", "The normal is the cross product of the edges B - A and C - A, not of the vertices.",
         normal, n_of_vertices},
    };
    return table;
}

}  // namespace harness::mistakes
