#include "harness/mark/diagnose/derivation.h"

#include <algorithm>
#include <utility>

#include "harness/mark/compare/first_hit.h"

namespace harness {
namespace {

using reference::Boundary;
using reference::Quadratic;
using reference::RootChoice;
using reference::Vec3;

using Targets = std::vector<Target>;
using Form = QuadraticForm;

/// compute(inputs...); empty if an input is missing.
template <class... Inputs>
Targets from(auto compute, const std::optional<Inputs>&... inputs) {
    if (!(inputs && ...)) return {};
    return {target_of(compute(*inputs...))};
}

Targets x_from_z(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const Vec3<Interval>& z) { return reference::normalized(reference::cross(scene.camera.vup, z)); },
                known.vector(item::Z_vcs));
}

// A vector of length 0 or axes in a plane give trivial results; a program gets no marks for printing zeros. Values
// whose digits allow 0 count as 0.
bool may_be_zero(const Interval& x) {
    return x.contains(0.0);
}
bool may_be_zero(const Vec3<Interval>& p) {
    return may_be_zero(p.x) && may_be_zero(p.y) && may_be_zero(p.z);
}

bool spans_space(const Vec3<Interval>& x, const Vec3<Interval>& y, const Vec3<Interval>& z) {
    return !may_be_zero(reference::dot(reference::cross(x, y), z));
}

std::optional<reference::Basis<Interval>> basis_of(const ItemTargets& known) {
    const auto x = known.vector(item::X_vcs), y = known.vector(item::Y_vcs), z = known.vector(item::Z_vcs);
    if (!x || !y || !z || !spans_space(*x, *y, *z)) return std::nullopt;
    return reference::Basis<Interval>{*x, *y, *z};
}

std::optional<reference::Mat4<Interval>> regular_matrix(const ItemTargets& known) {
    const auto m = known.matrix4(item::M_VCS_to_WCS);
    const auto axis = [&](int i) { return Vec3<Interval>((*m)[i][0], (*m)[i][1], (*m)[i][2]); };
    if (!m || !spans_space(axis(0), axis(1), axis(2))) return std::nullopt;
    return m;
}

Targets y_from_z_x(const ItemTargets& known, const IntervalScene&, Form) {
    const auto x = known.vector(item::X_vcs), z = known.vector(item::Z_vcs);
    if (!x || !z) return {};
    const Vec3<Interval> y = reference::cross(*z, *x);
    return may_be_zero(y) ? Targets{} : Targets{target_of(y)};
}

Targets m_from_basis(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const auto& basis) { return reference::vcs_to_wcs(basis, scene.camera.eye); }, basis_of(known));
}

Targets p_wcs_from_m(const ItemTargets& known, const IntervalScene&, Form) {
    return from([](const auto& m, const auto& p) { return reference::pixel_to_wcs(m, p); }, regular_matrix(known),
                known.vector(item::P_VCS));
}

/// The same without the division by w, for a matrix whose last row is not (0, 0, 0, 1).
Targets p_wcs_undivided(const ItemTargets& known, const IntervalScene&, Form) {
    return from(
        [](const reference::Mat4<Interval>& m, const Vec3<Interval>& p) {
            const auto row = [&](int i) { return m[0][i] * p.x + m[1][i] * p.y + m[2][i] * p.z + m[3][i]; };
            return Vec3<Interval>(row(0), row(1), row(2));
        },
        regular_matrix(known), known.vector(item::P_VCS));
}

Targets p_wcs_from_basis(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from(
        [&](const reference::Basis<Interval>& basis, const auto& p) {
            return Vec3<Interval>(scene.camera.eye + reference::scaled(basis.X_vcs, p.x) +
                                  reference::scaled(basis.Y_vcs, p.y) + reference::scaled(basis.Z_vcs, p.z));
        },
        basis_of(known), known.vector(item::P_VCS));
}

Targets v_from_p(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const auto& p) { return reference::ray_direction(p, scene.camera.eye); },
                known.vector(item::P_WCS));
}

/// V; empty if its length may be 0.
std::optional<Vec3<Interval>> direction_of(const ItemTargets& known) {
    const auto direction = known.vector(item::V);
    if (!direction || may_be_zero(*direction)) return std::nullopt;
    return direction;
}

std::optional<Quadratic<Interval>> quadratic_of(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const auto p = known.vector(item::P_WCS);
    const auto direction = direction_of(known);
    if (!p || !direction) return std::nullopt;
    Quadratic<Interval> quadratic = reference::sphere_quadratic(*p, *direction, scene.spheres.front());
    if (form == Form::half_b) {
        quadratic.b = quadratic.b / Interval(2);
        quadratic.d = quadratic.b * quadratic.b - quadratic.a * quadratic.c;
    }
    return quadratic;
}

template <Interval Quadratic<Interval>::*Coefficient>
Targets coefficient(const ItemTargets& known, const IntervalScene& scene, Form form) {
    return from([](const Quadratic<Interval>& q) { return q.*Coefficient; }, quadratic_of(known, scene, form));
}

/// a; empty if it may be zero, because the discriminant and roots are then trivial.
std::optional<Interval> leading_coefficient(const ItemTargets& known) {
    const auto p = known.scalar(item::sphere::a);
    return p && !may_be_zero(*p) ? p : std::nullopt;
}

Targets d_from_abc(const ItemTargets& known, const IntervalScene&, Form form) {
    const Interval factor(form == Form::half_b ? 1 : 4);
    const auto q = known.scalar(item::sphere::b), r = known.scalar(item::sphere::c);
    if (q && r && may_be_zero(*q) && may_be_zero(*r)) return {};
    return from([&](const Interval& p) { return *q * *q - factor * p * *r; },
                q && r ? leading_coefficient(known) : std::nullopt);
}

/// The hit root of a quadratic with these coefficients; several roots if rounding leaves a sign open.
Targets roots_of(Quadratic<Interval> quadratic, const IntervalScene& scene, Form form) {
    if (form == Form::half_b) {
        quadratic.b = quadratic.b * Interval(2);
        quadratic.d = quadratic.d * Interval(4);
    }
    if (sign_of(quadratic.a) < 0) quadratic = {-quadratic.a, -quadratic.b, -quadratic.c, quadratic.d};
    Targets targets;
    for (const Boundary boundary : scene.boundaries) {
        const RootChoice choice = reference::choose_root(quadratic, boundary);
        if (choice == RootChoice::miss) targets.push_back(no_value());
        const bool unsure = choice == RootChoice::unsure;
        if (unsure && !(sign_of(quadratic.c) < 0)) targets.push_back(no_value());
        for (const RootChoice root : {RootChoice::smaller, RootChoice::larger}) {
            if (choice == root || unsure) targets.push_back(target_of(*reference::root(quadratic, root)));
        }
    }
    return targets;
}

/// Computes c from a, b and d, because the student computed the roots from these three.
Targets t_from_abd(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const auto p = leading_coefficient(known), q = known.scalar(item::sphere::b), disc = known.scalar(item::sphere::d);
    if (!p || !q || !disc) return {};
    const Interval four_a_c = form == Form::half_b ? (*q * *q - *disc) * Interval(4) : *q * *q - *disc;
    return roots_of({*p, *q, four_a_c / (Interval(4) * *p), *disc}, scene, form);
}

Targets t_from_abc(const ItemTargets& known, const IntervalScene& scene, Form form) {
    const Targets disc = d_from_abc(known, scene, form);
    if (disc.empty()) return {};
    return roots_of({*known.scalar(item::sphere::a), *known.scalar(item::sphere::b), *known.scalar(item::sphere::c),
                     disc.front().components.front()},
                    scene, form);
}

Targets point_from_t(const ItemTargets& known, const ItemId& t) {
    const auto parameter = known.scalar(t);
    if (!parameter) return {no_value()};
    return from([&](const auto& p, const auto& direction) { return reference::point_on_ray(p, direction, *parameter); },
                known.vector(item::P_WCS), direction_of(known));
}

Targets sphere_point(const ItemTargets& known, const IntervalScene&, Form) {
    return point_from_t(known, item::sphere::t);
}

Targets sphere_normal_from_hit(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto hit = known.vector(item::sphere::hit);
    if (!hit) return {no_value()};
    const auto& sphere = scene.spheres.front();
    const Vec3<Interval> from_center = *hit - sphere.center;
    if (may_be_zero(from_center)) return {};
    return {target_of(reference::normalized(from_center)),
            target_of(reference::scaled(from_center, Interval(1) / sphere.radius))};
}

Targets matrix_from_v(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from(
        [&](const auto& p, const auto& direction) {
            return reference::triangle_system(p, direction, scene.triangles.front()).matrix;
        },
        known.vector(item::P_WCS), direction_of(known));
}

Targets rhs_from_p(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const auto& p) { return Vec3<Interval>(p - scene.triangles.front().A); },
                known.vector(item::P_WCS));
}

Targets solution(const std::optional<reference::LinearSystem<Interval>>& system,
                 Interval reference::CramerSolution<Interval>::*numerator) {
    if (!system) return {};
    const auto solved = reference::solve_by_cramer(*system);
    const auto det = sign_of(solved.det);
    if (!(det < 0 || det > 0)) return {};
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
    const HitValues values{
        {}, known.scalar(item::triangle::t), known.scalar(item::triangle::u), known.scalar(item::triangle::v)};
    const bool may_miss = std::any_of(scene.boundaries.begin(), scene.boundaries.end(),
                                      [&](Boundary boundary) { return hits_triangle(values, boundary) != Hits::yes; });
    if (may_miss) targets.push_back(no_value());  // without a true hit the point may be left out
    return targets;
}

Targets triangle_point_from_uv(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto& triangle = scene.triangles.front();
    return from(
        [&](const Interval& p, const Interval& q) {
            return Vec3<Interval>(triangle.A + reference::scaled(Vec3<Interval>(triangle.B - triangle.A), p) +
                                  reference::scaled(Vec3<Interval>(triangle.C - triangle.A), q));
        },
        known.scalar(item::triangle::u), known.scalar(item::triangle::v));
}

using Solved = reference::CramerSolution<Interval>;

const std::vector<Derivation>& derivations() {
    static const std::vector<Derivation> table = {
        {item::X_vcs, {item::Z_vcs}, x_from_z},
        {item::Y_vcs, {item::Z_vcs, item::X_vcs}, y_from_z_x},
        {item::M_VCS_to_WCS, {item::X_vcs, item::Y_vcs, item::Z_vcs}, m_from_basis},
        {item::P_WCS, {item::M_VCS_to_WCS, item::P_VCS}, p_wcs_from_m},
        {item::P_WCS, {item::M_VCS_to_WCS, item::P_VCS}, p_wcs_undivided},
        {item::P_WCS, {item::X_vcs, item::Y_vcs, item::Z_vcs, item::P_VCS}, p_wcs_from_basis},
        {item::V, {item::P_WCS}, v_from_p},
        {item::sphere::a, {item::V}, coefficient<&Quadratic<Interval>::a>},
        {item::sphere::b, {item::P_WCS, item::V}, coefficient<&Quadratic<Interval>::b>},
        {item::sphere::c, {item::P_WCS}, coefficient<&Quadratic<Interval>::c>},
        {item::sphere::d, {item::sphere::a, item::sphere::b, item::sphere::c}, d_from_abc},
        {item::sphere::t, {item::sphere::a, item::sphere::b, item::sphere::d}, t_from_abd},
        {item::sphere::t, {item::sphere::a, item::sphere::b, item::sphere::c}, t_from_abc},
        {item::sphere::hit, {item::P_WCS, item::V, item::sphere::t}, sphere_point},
        {item::sphere::normal, {item::sphere::hit}, sphere_normal_from_hit},
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
    };
    return table;
}

}  // namespace

std::span<const Derivation> all_derivations() {
    return derivations();
}

}  // namespace harness
