#include "reference/key/formulations.h"

#include <array>
#include <cmath>

namespace reference {
namespace {

using A3 = AffineVec3;

Mat3<Affine> linear_part(const Mat4<Affine>& M) {
    return {A3(M[0]), A3(M[1]), A3(M[2])};
}

/// glm::inverse: the cofactors by 2 x 2 determinants, times the reciprocal of the determinant.
Mat4<Affine> inverse_by_cofactors(const Mat4<Affine>& M) {
    // The 2 x 2 determinants of columns p, q and rows i, j.
    Affine minors[4][4][4][4];
    for (int p = 1; p < 4; ++p) {
        for (int q = p + 1; q < 4; ++q) {
            for (int i = 0; i < 4; ++i) {
                for (int j = i + 1; j < 4; ++j) minors[p][q][i][j] = M[p][i] * M[q][j] - M[q][i] * M[p][j];
            }
        }
    }
    const auto others = [](int left_out) {
        std::array<int, 3> rest{};
        for (int i = 0; i < 3; ++i) rest.at(static_cast<std::size_t>(i)) = i < left_out ? i : i + 1;
        return rest;
    };
    Mat4<Affine> inverse;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            // GLM expands along the first remaining column.
            const auto [p, q, s] = others(column);
            const auto [i, j, k] = others(row);
            const Affine cofactor =
                sum(M[p][i] * minors[q][s][j][k], -(M[p][j] * minors[q][s][i][k]), M[p][k] * minors[q][s][i][j]);
            inverse[row][column] = (column + row) % 2 == 0 ? cofactor : -cofactor;
        }
    }
    const Affine det =
        sum(M[0][0] * inverse[0][0], M[0][1] * inverse[1][0], M[0][2] * inverse[2][0], M[0][3] * inverse[3][0]);
    const Affine reciprocal = Affine(1) / det;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) inverse[column][row] *= reciprocal;
    }
    return inverse;
}

}  // namespace

A3 quotient(const A3& p, const Affine& divisor) {
    return {p.x / divisor, p.y / divisor, p.z / divisor};
}

A3 times(const Mat3<Affine>& M, const A3& p) {
    const auto row = [&](int i) { return sum(M[0][i] * p.x, M[1][i] * p.y, M[2][i] * p.z); };
    return {row(0), row(1), row(2)};
}

A3 unit_vector(const A3& p) {
    return scaled(p, reciprocal_root(dot(p, p)));
}

std::vector<Affine> window_coordinates(const Affine& from, const Affine& to, int index, int steps, int offset_halves) {
    const Affine n(steps);
    const Affine position = Affine(index) + Affine(offset_halves) / Affine(2);
    const Affine step = (to - from) / n;
    const Affine share = position / n;
    const Affine device = Affine(2) * position / n - Affine(1);
    return {from + (to - from) * position / n,
            from + share * (to - from),
            from + position * step,
            sum(from, step / Affine(2) * Affine(offset_halves), Affine(index) * step),
            from * (Affine(1) - share) + to * share,
            device * (to - from) / Affine(2) + (to + from) / Affine(2),
            from + (Affine(2) * Affine(index) + Affine(offset_halves)) * (to - from) / (Affine(2) * n)};
}

Basis<Affine> basis(const Camera<Affine>& camera, int way) {
    const A3 view = camera.eye - camera.lookat;
    const A3 Z = unit_vector(view);
    if (way < 2) {
        const A3 right = cross(camera.vup, view);
        const A3 X = unit_vector(right);
        return {X, way == 0 ? cross(Z, X) : unit_vector(cross(view, right)), Z};
    }
    const A3 up = way % 2 == 0 ? camera.vup : unit_vector(camera.vup);
    if (way < 4) {
        const A3 Y = unit_vector(A3(up - scaled(Z, dot(up, Z))));
        return {cross(Y, Z), Y, Z};
    }
    const A3 X = unit_vector(cross(up, Z));
    const A3 Y = cross(Z, X);
    return {X, way < 6 ? Y : unit_vector(Y), Z};
}

Mat4<Affine> inverse_view(const Basis<Affine>& basis, const A3& eye, int way) {
    if (way == 0) return vcs_to_wcs(basis, eye);
    const A3 &X = basis.X_vcs, &Y = basis.Y_vcs, &Z = basis.Z_vcs;
    const A3 moved(-dot(X, eye), -dot(Y, eye), -dot(Z, eye));
    if (way == 1) return vcs_to_wcs(basis, scaled(times(Mat3<Affine>(X, Y, Z), moved), Affine(-1)));
    const auto row = [&](int i) { return Vec4<Affine>(X[i], Y[i], Z[i], Affine()); };
    return inverse_by_cofactors({row(0), row(1), row(2), Vec4<Affine>(moved.x, moved.y, moved.z, Affine(1))});
}

std::vector<A3> points_in_wcs(const Mat4<Affine>& M, const A3& P_VCS) {
    const auto row = [&](int i) { return sum(M[0][i] * P_VCS.x, M[1][i] * P_VCS.y, M[2][i] * P_VCS.z, M[3][i]); };
    const A3 point(row(0), row(1), row(2));
    const Affine w = row(3);
    if (w.range().lo() == 1 && w.range().hi() == 1) return {point};
    return {point, quotient(point, w)};
}

std::vector<A3> directions(const Mat4<Affine>& M, const A3& P_VCS, const A3& P_WCS, const A3& eye,
                           Roundings& roundings) {
    Alternatives ways(roundings);
    std::vector<A3> result{unit_vector(A3(P_WCS - eye))};
    ways.next();
    result.push_back(unit_vector(times(linear_part(M), P_VCS)));
    ways.next();
    result.push_back(times(linear_part(M), unit_vector(P_VCS)));
    return result;
}

std::vector<Affine> quadratic_roots(const Quadratic<Affine>& quadratic, RootChoice choice, Roundings& roundings) {
    const auto& [a, b, c, d] = quadratic;
    const Affine spread = sqrt(d);
    const Affine signed_spread = choice == RootChoice::smaller ? -spread : spread;
    Alternatives ways(roundings);
    std::vector<Affine> result{(signed_spread - b) / (Affine(2) * a)};
    ways.next();
    result.push_back(signed_spread / (Affine(2) * a) - b / (Affine(2) * a));
    ways.next();
    const bool cancels = choice == RootChoice::smaller ? !(sign_of(b) > 0) : !(sign_of(b) < 0);
    if (cancels) result.push_back(Affine(2) * c / (-b - signed_spread));
    return result;
}

}  // namespace reference
