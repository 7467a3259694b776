#include "reference/key/formulations.h"

#include <array>
#include <cmath>
#include <functional>

namespace reference {
namespace {

using A3 = AffineVec3;

/// The matrix times p, each row's sum in any order.
A3 times(const Mat3<Affine>& M, const A3& p) {
    const auto row = [&](int i) { return sum(M[0][i] * p.x, M[1][i] * p.y, M[2][i] * p.z); };
    return {row(0), row(1), row(2)};
}

Mat3<Affine> linear_part(const Mat4<Affine>& M) {
    return {A3(M[0]), A3(M[1]), A3(M[2])};
}

A3 quotient(const A3& p, const Affine& divisor) {
    return {p.x / divisor, p.y / divisor, p.z / divisor};
}

/// glm::inverse: the cofactors by 2 x 2 determinants, times the determinant's reciprocal.
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
            // GLM expands along the first column that is left.
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

/// The determinant along its first row, as glm::determinant and glm::inverse have it.
Affine determinant(const Mat3<Affine>& M) {
    const auto minor = [&](int p, int q) { return M[p][1] * M[q][2] - M[q][1] * M[p][2]; };
    return sum(M[0][0] * minor(1, 2), -(M[1][0] * minor(0, 2)), M[2][0] * minor(0, 1));
}

/// The inverse by cofactors over the determinant, as glm::inverse has it.
Mat3<Affine> inverse_by_cofactors(const Mat3<Affine>& M) {
    const A3 rows[] = {cross(M[1], M[2]), cross(M[2], M[0]), cross(M[0], M[1])};
    const Affine reciprocal = Affine(1) / determinant(M);
    const auto column = [&](int i) {
        return A3(rows[0][i] * reciprocal, rows[1][i] * reciprocal, rows[2][i] * reciprocal);
    };
    return {column(0), column(1), column(2)};
}

/// Rows of a system of three equations and their right-hand sides.
using Equations = std::array<std::array<Affine, 4>, 3>;

/// The solutions by elimination of column k and the later ones, for every row that a program may take as the next:
/// those that may hold the largest pivot, and the first one if its pivot is not small beside that.
void eliminate(const Equations& from, std::size_t k, std::vector<Equations>& triangular) {
    constexpr double small = 1.0 / 64;
    if (k == 2) return triangular.push_back(from);
    double largest = 0;
    const auto size = [&](std::size_t i) {
        const Interval<double> range = from.at(i).at(k).range();
        return std::pair(range.contains(0) ? 0.0 : std::min(std::abs(range.lo()), std::abs(range.hi())),
                         std::max(std::abs(range.lo()), std::abs(range.hi())));
    };
    for (std::size_t i = k; i < 3; ++i) largest = std::max(largest, size(i).first);
    for (std::size_t pivot = k; pivot < 3; ++pivot) {
        const double needed = pivot == k ? small * largest : largest;
        if (size(pivot).second < needed || from.at(pivot).at(k).range().is_zero()) continue;
        Equations rows = from;
        std::swap(rows.at(k), rows.at(pivot));
        for (std::size_t i = k + 1; i < 3; ++i) {
            const Affine factor = rows.at(i).at(k) / rows.at(k).at(k);
            for (std::size_t j = k + 1; j < 4; ++j) rows.at(i).at(j) -= factor * rows.at(k).at(j);
        }
        eliminate(rows, k + 1, triangular);
    }
}

/// Gauss's elimination with pivots, the unknowns from the last to the first. Gauss and Jordan's differs in the order of
/// the same operations.
std::vector<A3> solve_by_elimination(const LinearSystem<Affine>& system) {
    Equations equations;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            equations.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j)) = system.matrix[j][i];
        equations.at(static_cast<std::size_t>(i))[3] = system.rhs[i];
    }
    std::vector<Equations> triangular;
    eliminate(equations, 0, triangular);
    std::vector<A3> solutions;
    for (const auto& [first, second, third] : triangular) {
        const Affine z = third[3] / third[2];
        const Affine y = (second[3] - second[2] * z) / second[1];
        const Affine x = sum(first[3], -(first[1] * y), -(first[2] * z)) / first[0];
        solutions.push_back({x, y, z});
    }
    return solutions;
}

}  // namespace

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

std::vector<Quadratic<Affine>> quadratics(const A3& start, const A3& V, const Sphere<Affine>& sphere,
                                          Roundings& roundings) {
    const A3 from_center = start - sphere.center;
    const Affine b = Affine(2) * dot(V, from_center);
    const Affine& radius = sphere.radius;
    const Affine &x = from_center.x, &y = from_center.y, &z = from_center.z;
    const Affine square = radius * radius;
    const std::function<Affine()> ways_to_c[] = {
        [&] { return sum(x * x, y * y, z * z, -square); },
        [&] {
            const Affine twice = Affine(2) * dot(start, sphere.center);
            return sum(dot(start, start), -twice, dot(sphere.center, sphere.center), -square);
        },
        [&] {
            const Affine length = sqrt(dot(from_center, from_center));
            return either(length * length - square, (length - radius) * (length + radius));
        }};
    std::vector<Quadratic<Affine>> result;
    Alternatives ways(roundings);
    for (const bool a_is_one : {false, true}) {
        for (const auto& way_to_c : ways_to_c) {
            const Affine a = a_is_one ? Affine(1) : dot(V, V);
            const Affine c = way_to_c();
            result.push_back({a, b, c, b * b - Affine(4) * a * c});
            ways.next();
        }
    }
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

std::vector<Affine> sphere_roots(const Quadratic<Affine>& quadratic, RootChoice choice, Roundings& roundings) {
    std::vector<Affine> result = quadratic_roots(quadratic, choice, roundings);
    Alternatives ways(roundings);
    const Affine spread = sqrt(quadratic.d);
    const Affine signed_spread = choice == RootChoice::smaller ? -spread : spread;
    result.push_back((signed_spread - quadratic.b) / Affine(2));
    return result;
}

std::vector<Affine> geometric_roots(const A3& start, const A3& V, const Sphere<Affine>& sphere, RootChoice choice,
                                    Roundings& roundings) {
    const A3 to_center = sphere.center - start;
    const Affine along = dot(to_center, V);
    const Affine square = sphere.radius * sphere.radius;
    const auto end = [&](const Affine& half) { return choice == RootChoice::smaller ? along - half : along + half; };
    Alternatives ways(roundings);
    std::vector<Affine> result{end(sqrt(sum(square, along * along, -dot(to_center, to_center))))};
    ways.next();
    const A3 nearest = to_center - scaled(V, along);
    result.push_back(end(sqrt(square - dot(nearest, nearest))));
    return result;
}

std::vector<A3> triangle_solutions(const LinearSystem<Affine>& system, Roundings& roundings) {
    const A3 V = scaled(system.matrix[0], Affine(-1));
    const A3& e1 = system.matrix[1];
    const A3& e2 = system.matrix[2];
    const A3& T = system.rhs;
    std::vector<A3> result;
    Alternatives ways(roundings);
    const CramerSolution<Affine> cramer = solve_by_cramer(system);
    result.push_back(quotient(A3(cramer.t_numerator, cramer.u_numerator, cramer.v_numerator), cramer.det));
    ways.next();
    result.push_back(times(inverse_by_cofactors(system.matrix), T));
    ways.next();
    const auto with_rhs_for = [&](int column) {
        Mat3<Affine> replaced = system.matrix;
        replaced[column] = T;
        return determinant(replaced);
    };
    result.push_back(quotient(A3(with_rhs_for(0), with_rhs_for(1), with_rhs_for(2)), determinant(system.matrix)));
    ways.next();
    // Möller and Trumbore's names.
    const A3 P = cross(V, e2);
    const A3 Q = cross(T, e1);
    result.push_back(quotient(A3(dot(e2, Q), dot(T, P), dot(V, Q)), dot(e1, P)));
    ways.next();
    for (const A3& solution : solve_by_elimination(system)) result.push_back(solution);
    ways.next();
    // The plane's point, and its barycentric coordinates from A: by dot products, and by areas.
    for (const bool is_unit : {false, true}) {
        const A3 doubled = cross(e1, e2);
        const A3 normal = is_unit ? unit_vector(doubled) : doubled;
        const Affine t = -dot(normal, T) / dot(normal, V);
        const A3 w = T + scaled(V, t);
        const Affine e11 = dot(e1, e1), e12 = dot(e1, e2), e22 = dot(e2, e2), w1 = dot(w, e1), w2 = dot(w, e2);
        const Affine gram = e11 * e22 - e12 * e12;
        result.push_back({t, (e22 * w1 - e12 * w2) / gram, (e11 * w2 - e12 * w1) / gram});
        const Affine square = dot(doubled, doubled);
        result.push_back({t, dot(cross(w, e2), doubled) / square, dot(cross(e1, w), doubled) / square});
        ways.next();
    }
    return result;
}

std::vector<A3> triangle_normals(const Triangle<Affine>& triangle, Roundings& roundings) {
    const A3 e1 = triangle.B - triangle.A;
    const A3 e2 = triangle.C - triangle.A;
    Alternatives ways(roundings);
    std::vector<A3> result{unit_vector(cross(e1, e2))};
    ways.next();
    result.push_back(unit_vector(cross(unit_vector(e1), unit_vector(e2))));
    ways.next();
    result.push_back(unit_vector(cross(e1, A3(triangle.C - triangle.B))));
    return result;
}

}  // namespace reference
