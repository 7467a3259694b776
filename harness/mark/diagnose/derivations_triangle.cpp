// How the items of the triangle follow from those before them.
#include "harness/mark/diagnose/derivation_parts.h"

namespace harness::derivations {
namespace triangle_derivations {
namespace {

using reference::Boundary;
using reference::Subject;

Targets matrix_from_v(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from(
        [&](const auto& p, const auto& direction) {
            return reference::triangle_system(p, direction, scene.triangles.front()).matrix;
        },
        known.vector(item::P_WCS), direction_of(known));
}

Targets rhs_from_p(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const auto& p) { return Vec(p - scene.triangles.front().A); }, known.vector(item::P_WCS));
}

Targets solution(const std::optional<reference::LinearSystem<Interval>>& system,
                 Interval reference::CramerSolution<Interval>::*numerator) {
    if (!system) return {};
    const auto solved = reference::solve_by_cramer(*system);
    const auto det = sign_of(solved.det);
    if (!(det < 0 || det > 0)) return {no_value()};
    return {target_of(solved.*numerator / solved.det)};
}

template <Interval reference::CramerSolution<Interval>::*Numerator>
Targets solve_printed(const ItemTargets& known, const IntervalScene&, Form) {
    const auto m = known.matrix3(item::triangle::matrix);
    const auto r = known.vector(item::triangle::rhs);
    if (!m || !r) return {};
    return solution(reference::LinearSystem<Interval>{*m, *r}, Numerator);
}

template <Interval reference::CramerSolution<Interval>::*Numerator>
Targets solve_ray(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto p = known.vector(item::P_WCS);
    const auto direction = direction_of(known);
    if (!p || !direction) return {};
    return solution(reference::triangle_system(*p, *direction, scene.triangles.front()), Numerator);
}

Targets triangle_point(const ItemTargets& known, const IntervalScene& scene, Form) {
    Targets targets = point_from_t(known, item::triangle::t);
    const HitValues values{{{Subject::triangle, known.scalar(item::triangle::t)}},
                           known.scalar(item::triangle::u),
                           known.scalar(item::triangle::v)};
    const bool may_miss = std::any_of(scene.boundaries.begin(), scene.boundaries.end(),
                                      [&](Boundary boundary) { return hits_triangle(values, boundary) != Hits::yes; });
    if (may_miss) targets.push_back(no_value());  // without a hit, the student may omit the point
    return targets;
}

Targets triangle_point_from_uv(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto& triangle = scene.triangles.front();
    return from(
        [&](const Interval& p, const Interval& q) {
            return Vec(triangle.A + reference::scaled(Vec(triangle.B - triangle.A), p) +
                       reference::scaled(Vec(triangle.C - triangle.A), q));
        },
        known.scalar(item::triangle::u), known.scalar(item::triangle::v));
}

/// The normal from the edges in the student's own matrix.
Targets normal_from_matrix(const ItemTargets& known, const IntervalScene&, Form) {
    const auto m = known.matrix3(item::triangle::matrix);
    if (!m) return {};
    const Vec normal = reference::cross((*m)[1], (*m)[2]);
    return may_be_zero(normal) ? Targets{} : Targets{target_of(reference::normalized(normal))};
}

using Solved = reference::CramerSolution<Interval>;

}  // namespace
}  // namespace triangle_derivations

template <>
const std::vector<Derivation>& of<Subject::triangle>() {
    using namespace triangle_derivations;
    static const std::vector<Derivation> table = {
        {item::triangle::matrix, {item::V}, matrix_from_v},
        {item::triangle::rhs, {item::P_WCS}, rhs_from_p},
        {item::triangle::t, {item::triangle::matrix, item::triangle::rhs}, solve_printed<&Solved::t_numerator>},
        {item::triangle::u, {item::triangle::matrix, item::triangle::rhs}, solve_printed<&Solved::u_numerator>},
        {item::triangle::v, {item::triangle::matrix, item::triangle::rhs}, solve_printed<&Solved::v_numerator>},
        {item::triangle::t, {item::P_WCS, item::V}, solve_ray<&Solved::t_numerator>},
        {item::triangle::u, {item::P_WCS, item::V}, solve_ray<&Solved::u_numerator>},
        {item::triangle::v, {item::P_WCS, item::V}, solve_ray<&Solved::v_numerator>},
        {item::triangle::hit,
         {item::P_WCS, item::V, item::triangle::t, item::triangle::u, item::triangle::v},
         triangle_point},
        {item::triangle::hit, {item::triangle::u, item::triangle::v}, triangle_point_from_uv},
        {item::triangle::normal, {item::triangle::matrix}, normal_from_matrix},
    };
    return table;
}

template <>
std::vector<ItemId> close_calls_of<Subject::triangle>() {
    using namespace triangle_derivations;
    return {item::triangle::hit};
}

}  // namespace harness::derivations
