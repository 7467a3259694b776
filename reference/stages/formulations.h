// The handout's stages as students usually write them. Every function lists results that are equal over the real
// numbers and differ in their roundings only; over Interval<float> they bound what correct programs print.
#pragma once

#include "reference/stages/pipeline.h"

namespace reference {

/// Normalises as GLM does, by multiplying by the reciprocal of the length. Dividing by the length has one rounding
/// less, so a bound of this formula holds for the division too.
template <class S>
Vec3<S> unit_vector(const Vec3<S>& p) {
    return scaled(p, S(S(1) / length(p)));
}

/// One coordinate of question 1. `offset_halves` is 1 for a pixel's centre and 0 for its corner; `steps` is the number
/// of pixels, or one less for the grid.
template <class S>
std::vector<S> window_coordinates(const S& from, const S& to, int index, int steps, int offset_halves) {
    const S n(steps);
    const S position = S(index) + S(offset_halves) / S(2);
    const S step = (to - from) / n;
    return {from + (to - from) * position / n, from + position / n * (to - from), from + position * step,
            from + step / S(2) * S(offset_halves) + S(index) * step,
            from + (S(2) * S(index) + S(offset_halves)) * (to - from) / (S(2) * n)};
}

/// Question 2: from unit vectors, with vup as given or normalised, or from vectors that are normalised last.
/// glm::lookAt has the same axes in its rows.
template <class S>
std::vector<Basis<S>> bases(const Camera<S>& camera) {
    const Vec3<S> view = camera.eye - camera.lookat;
    const Vec3<S> Z = unit_vector(view);
    const Vec3<S> X = unit_vector(cross(camera.vup, Z));
    const Vec3<S> X_of_unit_up = unit_vector(cross(unit_vector(camera.vup), Z));
    const Vec3<S> right = cross(camera.vup, view);
    return {{X, cross(Z, X), Z},
            {X_of_unit_up, cross(Z, X_of_unit_up), Z},
            {unit_vector(right), unit_vector(cross(view, right)), Z},
            {unit_vector(right), unit_vector(cross(Z, unit_vector(right))), Z}};
}

/// The inverse by cofactors over the determinant, as glm::inverse has it.
template <class S>
Mat3<S> inverse_by_cofactors(const Mat3<S>& M) {
    const Vec3<S> rows[] = {cross(M[1], M[2]), cross(M[2], M[0]), cross(M[0], M[1])};
    const S reciprocal = S(1) / dot(M[0], rows[0]);
    const auto column = [&](int i) {
        return Vec3<S>(rows[0][i] * reciprocal, rows[1][i] * reciprocal, rows[2][i] * reciprocal);
    };
    return Mat3<S>(column(0), column(1), column(2));
}

template <class S>
Vec3<S> times(const Mat3<S>& M, const Vec3<S>& p) {
    return scaled(M[0], p.x) + scaled(M[1], p.y) + scaled(M[2], p.z);
}

/// Question 3: the axes and the eye as columns, and the view matrix inverted, as a rigid motion or by cofactors.
template <class S>
std::vector<Mat4<S>> inverse_views(const Basis<S>& basis, const Vec3<S>& eye) {
    const Vec3<S> moved(-dot(basis.X_vcs, eye), -dot(basis.Y_vcs, eye), -dot(basis.Z_vcs, eye));
    const auto column = [&](int i) { return Vec3<S>(basis.X_vcs[i], basis.Y_vcs[i], basis.Z_vcs[i]); };
    const Mat3<S> transposed(basis.X_vcs, basis.Y_vcs, basis.Z_vcs);
    const Mat3<S> inverse = inverse_by_cofactors(Mat3<S>(column(0), column(1), column(2)));
    return {vcs_to_wcs(basis, eye), vcs_to_wcs(basis, scaled(times(transposed, moved), S(-1))),
            vcs_to_wcs(Basis<S>{inverse[0], inverse[1], inverse[2]}, scaled(times(inverse, moved), S(-1)))};
}

/// Question 6, t, for `choice` smaller or larger: by the textbook's formula, with half of b, and without cancellation.
template <class S>
std::vector<S> sphere_roots(const Quadratic<S>& quadratic, RootChoice choice) {
    const auto& [a, b, c, d] = quadratic;
    const S h = b / S(2);
    const auto signed_root = [&](const S& spread) { return choice == RootChoice::smaller ? S(-spread) : spread; };
    const S spread = sqrt(d);
    const S half_spread = sqrt(S(h * h - a * c));
    std::vector<S> result{S(-b + signed_root(spread)) / (S(2) * a), S(-b + signed_root(spread)) / S(2),
                          S(-h + signed_root(half_spread)) / a};
    const bool cancels = choice == RootChoice::smaller ? !(sign_of(b) > 0) : !(sign_of(b) < 0);
    if (cancels) result.push_back(S(2) * c / S(-b - signed_root(spread)));
    return result;
}

/// Question 8: t, u and v in this order.
template <class S>
std::vector<Vec3<S>> triangle_solutions(const LinearSystem<S>& system) {
    const Vec3<S> V = scaled(system.matrix[0], S(-1));
    const Vec3<S>& e1 = system.matrix[1];
    const Vec3<S>& e2 = system.matrix[2];
    const CramerSolution<S> cramer = solve_by_cramer(system);
    // Möller and Trumbore (1997), with their names for P, T and Q.
    const Vec3<S>& T = system.rhs;
    const Vec3<S> P = cross(V, e2);
    const Vec3<S> Q = cross(T, e1);
    const S reciprocal = S(1) / dot(e1, P);
    return {Vec3<S>(cramer.t_numerator / cramer.det, cramer.u_numerator / cramer.det, cramer.v_numerator / cramer.det),
            times(inverse_by_cofactors(system.matrix), system.rhs),
            Vec3<S>(dot(e2, Q) * reciprocal, dot(T, P) * reciprocal, dot(V, Q) * reciprocal)};
}

/// Question 8, t: the distance to the plane over the approach to it.
template <class S>
S plane_distance(const LinearSystem<S>& system, const Vec3<S>& normal) {
    return dot(normal, system.rhs) / dot(normal, system.matrix[0]);
}

}  // namespace reference
