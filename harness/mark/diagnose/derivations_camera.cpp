// How the items of the camera follow from each other.
#include "harness/mark/diagnose/derivation_parts.h"

namespace harness::derivations {
namespace camera_derivations {
namespace {

Targets x_from_z(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const Vec& z) { return reference::normalized(reference::cross(scene.camera.vup, z)); },
                known.vector(item::Z_vcs));
}

/// Three axes that all have length 0 or the same direction give trivial results.
bool is_trivial(const Vec& x, const Vec& y, const Vec& z) {
    return may_be_zero(reference::cross(x, y)) && may_be_zero(reference::cross(y, z)) &&
           may_be_zero(reference::cross(z, x));
}

std::optional<reference::Basis<Interval>> basis_of(const ItemTargets& known) {
    const auto x = known.vector(item::X_vcs), y = known.vector(item::Y_vcs), z = known.vector(item::Z_vcs);
    if (!x || !y || !z || is_trivial(*x, *y, *z)) return std::nullopt;
    return reference::Basis<Interval>{*x, *y, *z};
}

std::optional<reference::Mat4<Interval>> matrix_of_axes(const ItemTargets& known) {
    const auto m = known.matrix4(item::M_VCS_to_WCS);
    const auto axis = [&](int i) { return Vec((*m)[i][0], (*m)[i][1], (*m)[i][2]); };
    if (!m || is_trivial(axis(0), axis(1), axis(2))) return std::nullopt;
    return m;
}

Targets y_from_z_x(const ItemTargets& known, const IntervalScene&, Form) {
    const auto x = known.vector(item::X_vcs), z = known.vector(item::Z_vcs);
    if (!x || !z) return {};
    const Vec y = reference::cross(*z, *x);
    return may_be_zero(y) ? Targets{} : Targets{target_of(y)};
}

Targets m_from_basis(const ItemTargets& known, const IntervalScene& scene, Form) {
    const auto basis = basis_of(known);
    if (!basis) return {};
    const auto& [x, y, z] = *basis;
    Targets targets = {target_of(reference::vcs_to_wcs(*basis, scene.camera.eye))};
    // The inverse of the view matrix, whose rows are the axes. If these are not an orthonormal basis, it is not the
    // transpose.
    const Interval det = reference::dot(reference::cross(x, y), z);
    if (may_be_zero(det)) return targets;
    const auto column = [&](const Vec& p, const Vec& q) {
        return reference::scaled(reference::cross(p, q), Interval(1) / det);
    };
    targets.push_back(target_of(
        reference::vcs_to_wcs(reference::Basis<Interval>{column(y, z), column(z, x), column(x, y)}, scene.camera.eye)));
    return targets;
}

Targets p_wcs_from_m(const ItemTargets& known, const IntervalScene&, Form) {
    return from([](const auto& m, const auto& p) { return reference::pixel_to_wcs(m, p); }, matrix_of_axes(known),
                known.vector(item::P_VCS));
}

/// The same without the division by w, for a matrix whose last row is not (0, 0, 0, 1); also with that w.
Targets p_wcs_undivided(const ItemTargets& known, const IntervalScene&, Form) {
    const auto m = matrix_of_axes(known);
    const auto p = known.vector(item::P_VCS);
    if (!m || !p) return {};
    const auto row = [&](int i) { return (*m)[0][i] * p->x + (*m)[1][i] * p->y + (*m)[2][i] * p->z + (*m)[3][i]; };
    const Target point = target_of(Vec(row(0), row(1), row(2)));
    Target with_w = point;
    with_w.components.push_back(row(3));
    return {point, with_w};
}

Targets p_wcs_from_basis(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from(
        [&](const reference::Basis<Interval>& basis, const auto& p) {
            return Vec(scene.camera.eye + reference::scaled(basis.X_vcs, p.x) + reference::scaled(basis.Y_vcs, p.y) +
                       reference::scaled(basis.Z_vcs, p.z));
        },
        basis_of(known), known.vector(item::P_VCS));
}

Targets v_from_p(const ItemTargets& known, const IntervalScene& scene, Form) {
    return from([&](const auto& p) { return reference::ray_direction(p, scene.camera.eye); },
                known.vector(item::P_WCS));
}

}  // namespace
}  // namespace camera_derivations

template <>
const std::vector<Derivation>& of<Subject::camera>() {
    using namespace camera_derivations;
    static const std::vector<Derivation> table = {
        {item::X_vcs, {item::Z_vcs}, x_from_z},
        {item::Y_vcs, {item::Z_vcs, item::X_vcs}, y_from_z_x},
        {item::M_VCS_to_WCS, {item::X_vcs, item::Y_vcs, item::Z_vcs}, m_from_basis},
        {item::P_WCS, {item::M_VCS_to_WCS, item::P_VCS}, p_wcs_from_m},
        {item::P_WCS, {item::M_VCS_to_WCS, item::P_VCS}, p_wcs_undivided},
        {item::P_WCS, {item::X_vcs, item::Y_vcs, item::Z_vcs, item::P_VCS}, p_wcs_from_basis},
        {item::V, {item::P_WCS}, v_from_p},
    };
    return table;
}

}  // namespace harness::derivations
