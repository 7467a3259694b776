#include "harness/derivation.h"

#include <algorithm>
#include <utility>

#include "harness/own_verdict.h"

namespace harness {
namespace {

using reference::Boundary;
using reference::Quadratic;
using reference::RootChoice;
using reference::Vec3;

using Targets = std::vector<Target>;
using Form = QuadraticForm;

constexpr ItemId P_VCS{1, "P_VCS"}, X{2, "X_vcs"}, Y{2, "Y_vcs"}, Z{2, "Z_vcs"}, M{3, "M_VCS_to_WCS"},
    P_WCS{4, "P_WCS"}, V{5, "V"};
constexpr ItemId a{6, "a"}, b{6, "b"}, c{6, "c"}, d{6, "d"}, t_s{6, "t"}, hit_s{6, "hit"}, normal_s{7, "normal"};
constexpr ItemId matrix{8, "matrix"}, rhs{8, "rhs"}, t_t{8, "t"}, u{8, "u"}, v{8, "v"}, hit_t{8, "hit"};

/// The value, unless an input is missing.
template <class... Inputs>
Targets from(auto compute, const std::optional<Inputs>&... inputs) {
    if (!(inputs && ...)) return {};
    return {target_of(compute(*inputs...))};
}

Targets x_from_z(const Known& known, const RealScene& scene, Form) {
    return from([&](const Vec3<Real>& z) { return reference::normalized(reference::cross(scene.camera.vup, z)); },
                known.vector(Z));
}

// What follows from a vector without length, or from axes in one plane, is trivial: a program that prints zeros is not
// marked for them. Digits that leave it open count as zeros.
bool may_be_zero(const Real& x) {
    return x.contains(0.0);
}
bool may_be_zero(const Vec3<Real>& p) {
    return may_be_zero(p.x) && may_be_zero(p.y) && may_be_zero(p.z);
}

bool spans_space(const Vec3<Real>& x, const Vec3<Real>& y, const Vec3<Real>& z) {
    return !may_be_zero(reference::dot(reference::cross(x, y), z));
}

std::optional<reference::Basis<Real>> basis_of(const Known& known) {
    const auto x = known.vector(X), y = known.vector(Y), z = known.vector(Z);
    if (!x || !y || !z || !spans_space(*x, *y, *z)) return std::nullopt;
    return reference::Basis<Real>{*x, *y, *z};
}

std::optional<reference::Mat4<Real>> regular_matrix(const Known& known) {
    const auto m = known.matrix4(M);
    const auto axis = [&](int i) { return Vec3<Real>((*m)[i][0], (*m)[i][1], (*m)[i][2]); };
    if (!m || !spans_space(axis(0), axis(1), axis(2))) return std::nullopt;
    return m;
}

Targets y_from_z_x(const Known& known, const RealScene&, Form) {
    const auto x = known.vector(X), z = known.vector(Z);
    if (!x || !z) return {};
    const Vec3<Real> y = reference::cross(*z, *x);
    return may_be_zero(y) ? Targets{} : Targets{target_of(y)};
}

Targets m_from_basis(const Known& known, const RealScene& scene, Form) {
    return from([&](const auto& basis) { return reference::vcs_to_wcs(basis, scene.camera.eye); }, basis_of(known));
}

Targets p_wcs_from_m(const Known& known, const RealScene&, Form) {
    return from([](const auto& m, const auto& p) { return reference::pixel_to_wcs(m, p); }, regular_matrix(known),
                known.vector(P_VCS));
}

/// The same without the division by w, for a matrix whose last row is not (0, 0, 0, 1).
Targets p_wcs_undivided(const Known& known, const RealScene&, Form) {
    return from(
        [](const reference::Mat4<Real>& m, const Vec3<Real>& p) {
            const auto row = [&](int i) { return m[0][i] * p.x + m[1][i] * p.y + m[2][i] * p.z + m[3][i]; };
            return Vec3<Real>(row(0), row(1), row(2));
        },
        regular_matrix(known), known.vector(P_VCS));
}

Targets p_wcs_from_basis(const Known& known, const RealScene& scene, Form) {
    return from(
        [&](const reference::Basis<Real>& basis, const auto& p) {
            return Vec3<Real>(scene.camera.eye + reference::scaled(basis.X_vcs, p.x) +
                              reference::scaled(basis.Y_vcs, p.y) + reference::scaled(basis.Z_vcs, p.z));
        },
        basis_of(known), known.vector(P_VCS));
}

Targets v_from_p(const Known& known, const RealScene& scene, Form) {
    return from([&](const auto& p) { return reference::ray_direction(p, scene.camera.eye); }, known.vector(P_WCS));
}

/// V, unless it has no length.
std::optional<Vec3<Real>> direction_of(const Known& known) {
    const auto direction = known.vector(V);
    if (!direction || may_be_zero(*direction)) return std::nullopt;
    return direction;
}

std::optional<Quadratic<Real>> quadratic_of(const Known& known, const RealScene& scene, Form form) {
    const auto p = known.vector(P_WCS);
    const auto direction = direction_of(known);
    if (!p || !direction) return std::nullopt;
    Quadratic<Real> quadratic = reference::sphere_quadratic(*p, *direction, scene.spheres.front());
    if (form == Form::half_b) {
        quadratic.b = quadratic.b / Real(2);
        quadratic.d = quadratic.b * quadratic.b - quadratic.a * quadratic.c;
    }
    return quadratic;
}

template <Real Quadratic<Real>::*Coefficient>
Targets coefficient(const Known& known, const RealScene& scene, Form form) {
    return from([](const Quadratic<Real>& q) { return q.*Coefficient; }, quadratic_of(known, scene, form));
}

/// a, unless it is zero: without it there is no quadratic, and its discriminant and roots are trivial.
std::optional<Real> leading_coefficient(const Known& known) {
    const auto p = known.scalar(a);
    return p && !may_be_zero(*p) ? p : std::nullopt;
}

Targets d_from_abc(const Known& known, const RealScene&, Form form) {
    const Real factor(form == Form::half_b ? 1 : 4);
    const auto q = known.scalar(b), r = known.scalar(c);
    if (q && r && may_be_zero(*q) && may_be_zero(*r)) return {};
    return from([&](const Real& p) { return *q * *q - factor * p * *r; },
                q && r ? leading_coefficient(known) : std::nullopt);
}

/// The hit root of a quadratic given by its coefficients; each root that a rounded sign leaves possible.
Targets roots_of(Quadratic<Real> quadratic, const RealScene& scene, Form form) {
    if (form == Form::half_b) {
        quadratic.b = quadratic.b * Real(2);
        quadratic.d = quadratic.d * Real(4);
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

/// c is taken to agree with a, b and d, from which the student computed the roots.
Targets t_from_abd(const Known& known, const RealScene& scene, Form form) {
    const auto p = leading_coefficient(known), q = known.scalar(b), disc = known.scalar(d);
    if (!p || !q || !disc) return {};
    const Real four_a_c = form == Form::half_b ? (*q * *q - *disc) * Real(4) : *q * *q - *disc;
    return roots_of({*p, *q, four_a_c / (Real(4) * *p), *disc}, scene, form);
}

Targets t_from_abc(const Known& known, const RealScene& scene, Form form) {
    const Targets disc = d_from_abc(known, scene, form);
    if (disc.empty()) return {};
    return roots_of({*known.scalar(a), *known.scalar(b), *known.scalar(c), disc.front().components.front()}, scene,
                    form);
}

Targets point_from_t(const Known& known, const ItemId& t) {
    const auto parameter = known.scalar(t);
    if (!parameter) return {no_value()};
    return from([&](const auto& p, const auto& direction) { return reference::point_on_ray(p, direction, *parameter); },
                known.vector(P_WCS), direction_of(known));
}

Targets sphere_point(const Known& known, const RealScene&, Form) {
    return point_from_t(known, t_s);
}

Targets sphere_normal_from_hit(const Known& known, const RealScene& scene, Form) {
    const auto hit = known.vector(hit_s);
    if (!hit) return {no_value()};
    const auto& sphere = scene.spheres.front();
    const Vec3<Real> from_center = *hit - sphere.center;
    if (may_be_zero(from_center)) return {};
    return {target_of(reference::normalized(from_center)),
            target_of(reference::scaled(from_center, Real(1) / sphere.radius))};
}

Targets matrix_from_v(const Known& known, const RealScene& scene, Form) {
    return from(
        [&](const auto& p, const auto& direction) {
            return reference::triangle_system(p, direction, scene.triangles.front()).matrix;
        },
        known.vector(P_WCS), direction_of(known));
}

Targets rhs_from_p(const Known& known, const RealScene& scene, Form) {
    return from([&](const auto& p) { return Vec3<Real>(p - scene.triangles.front().A); }, known.vector(P_WCS));
}

Targets solution(const std::optional<reference::LinearSystem<Real>>& system,
                 Real reference::CramerSolution<Real>::*numerator) {
    if (!system) return {};
    const auto solved = reference::solve_by_cramer(*system);
    const auto det = sign_of(solved.det);
    if (!(det < 0 || det > 0)) return {};
    return {target_of(solved.*numerator / solved.det)};
}

template <Real reference::CramerSolution<Real>::*Numerator>
Targets solve_printed(const Known& known, const RealScene&, Form) {
    const auto m = known.matrix3(matrix);
    const auto r = known.vector(rhs);
    if (!m || !r) return {};
    return solution(reference::LinearSystem<Real>{*m, *r}, Numerator);
}

template <Real reference::CramerSolution<Real>::*Numerator>
Targets solve_ray(const Known& known, const RealScene& scene, Form) {
    const auto p = known.vector(P_WCS);
    const auto direction = direction_of(known);
    if (!p || !direction) return {};
    return solution(reference::triangle_system(*p, *direction, scene.triangles.front()), Numerator);
}

Targets triangle_point(const Known& known, const RealScene& scene, Form) {
    Targets targets = point_from_t(known, t_t);
    const HitValues values{{}, known.scalar(t_t), known.scalar(u), known.scalar(v)};
    const bool may_miss = std::any_of(scene.boundaries.begin(), scene.boundaries.end(),
                                      [&](Boundary boundary) { return hits_triangle(values, boundary) != Hits::yes; });
    if (may_miss) targets.push_back(no_value());  // without a true hit the point may be left out
    return targets;
}

Targets triangle_point_from_uv(const Known& known, const RealScene& scene, Form) {
    const auto& triangle = scene.triangles.front();
    return from(
        [&](const Real& p, const Real& q) {
            return Vec3<Real>(triangle.A + reference::scaled(Vec3<Real>(triangle.B - triangle.A), p) +
                              reference::scaled(Vec3<Real>(triangle.C - triangle.A), q));
        },
        known.scalar(u), known.scalar(v));
}

using Solved = reference::CramerSolution<Real>;

const std::vector<Derivation>& derivations() {
    static const std::vector<Derivation> table = {
        {X, {Z}, x_from_z},
        {Y, {Z, X}, y_from_z_x},
        {M, {X, Y, Z}, m_from_basis},
        {P_WCS, {M, P_VCS}, p_wcs_from_m},
        {P_WCS, {M, P_VCS}, p_wcs_undivided},
        {P_WCS, {X, Y, Z, P_VCS}, p_wcs_from_basis},
        {V, {P_WCS}, v_from_p},
        {a, {V}, coefficient<&Quadratic<Real>::a>},
        {b, {P_WCS, V}, coefficient<&Quadratic<Real>::b>},
        {c, {P_WCS}, coefficient<&Quadratic<Real>::c>},
        {d, {a, b, c}, d_from_abc},
        {t_s, {a, b, d}, t_from_abd},
        {t_s, {a, b, c}, t_from_abc},
        {hit_s, {P_WCS, V, t_s}, sphere_point},
        {normal_s, {hit_s}, sphere_normal_from_hit},
        {matrix, {V}, matrix_from_v},
        {rhs, {P_WCS}, rhs_from_p},
        {t_t, {matrix, rhs}, solve_printed<&Solved::t_numerator>},
        {u, {matrix, rhs}, solve_printed<&Solved::u_numerator>},
        {v, {matrix, rhs}, solve_printed<&Solved::v_numerator>},
        {t_t, {P_WCS, V}, solve_ray<&Solved::t_numerator>},
        {u, {P_WCS, V}, solve_ray<&Solved::u_numerator>},
        {v, {P_WCS, V}, solve_ray<&Solved::v_numerator>},
        {hit_t, {P_WCS, V, t_t, u, v}, triangle_point},
        {hit_t, {u, v}, triangle_point_from_uv},
    };
    return table;
}

}  // namespace

std::span<const Derivation> all_derivations() {
    return derivations();
}

}  // namespace harness
