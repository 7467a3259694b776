#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "reference/key/object_programs.h"

namespace reference {
namespace {

/// The determinant along its first row, as in glm::determinant and glm::inverse.
Affine determinant(const Mat3<Affine>& M) {
    const auto minor = [&](int p, int q) { return M[p][1] * M[q][2] - M[q][1] * M[p][2]; };
    return sum(M[0][0] * minor(1, 2), -(M[1][0] * minor(0, 2)), M[2][0] * minor(0, 1));
}

/// The inverse by cofactors over the determinant, as in glm::inverse.
Mat3<Affine> inverse_by_cofactors(const Mat3<Affine>& M) {
    const AffineVec3 rows[] = {cross(M[1], M[2]), cross(M[2], M[0]), cross(M[0], M[1])};
    const Affine reciprocal = Affine(1) / determinant(M);
    const auto column = [&](int i) {
        return AffineVec3(rows[0][i] * reciprocal, rows[1][i] * reciprocal, rows[2][i] * reciprocal);
    };
    return {column(0), column(1), column(2)};
}

/// Rows of a system of three equations and their right-hand sides.
using Equations = std::array<std::array<Affine, 4>, 3>;

/// The solutions by elimination of column k and the later ones, for every row that a program may choose next: those
/// that may have the largest pivot, and the first one if its pivot is not much smaller.
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

/// Gauss's elimination with pivots, from the last unknown to the first. Gauss-Jordan only changes the order of the same
/// operations.
std::vector<AffineVec3> solve_by_elimination(const LinearSystem<Affine>& system) {
    Equations equations;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            equations.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j)) = system.matrix[j][i];
        equations.at(static_cast<std::size_t>(i))[3] = system.rhs[i];
    }
    std::vector<Equations> triangular;
    eliminate(equations, 0, triangular);
    std::vector<AffineVec3> solutions;
    for (const auto& [first, second, third] : triangular) {
        const Affine z = third[3] / third[2];
        const Affine y = (second[3] - second[2] * z) / second[1];
        const Affine x = sum(first[3], -(first[1] * y), -(first[2] * z)) / first[0];
        solutions.push_back({x, y, z});
    }
    return solutions;
}

/// Question 8: t, u and v in this order.
std::vector<AffineVec3> triangle_solutions(const LinearSystem<Affine>& system, Roundings& roundings) {
    const AffineVec3 V = scaled(system.matrix[0], Affine(-1));
    const AffineVec3& e1 = system.matrix[1];
    const AffineVec3& e2 = system.matrix[2];
    const AffineVec3& T = system.rhs;
    std::vector<AffineVec3> result;
    Alternatives ways(roundings);
    const CramerSolution<Affine> cramer = solve_by_cramer(system);
    result.push_back(quotient(AffineVec3(cramer.t_numerator, cramer.u_numerator, cramer.v_numerator), cramer.det));
    ways.next();
    result.push_back(times(inverse_by_cofactors(system.matrix), T));
    ways.next();
    const auto with_rhs_for = [&](int column) {
        Mat3<Affine> replaced = system.matrix;
        replaced[column] = T;
        return determinant(replaced);
    };
    result.push_back(
        quotient(AffineVec3(with_rhs_for(0), with_rhs_for(1), with_rhs_for(2)), determinant(system.matrix)));
    ways.next();
    // Möller and Trumbore's names.
    const AffineVec3 P = cross(V, e2);
    const AffineVec3 Q = cross(T, e1);
    result.push_back(quotient(AffineVec3(dot(e2, Q), dot(T, P), dot(V, Q)), dot(e1, P)));
    ways.next();
    for (const AffineVec3& solution : solve_by_elimination(system)) result.push_back(solution);
    ways.next();
    // The plane's point, and its barycentric coordinates from A: by dot products, and by areas.
    for (const bool is_unit : {false, true}) {
        const AffineVec3 doubled = cross(e1, e2);
        const AffineVec3 normal = is_unit ? unit_vector(doubled) : doubled;
        const Affine t = -dot(normal, T) / dot(normal, V);
        const AffineVec3 w = T + scaled(V, t);
        const Affine e11 = dot(e1, e1), e12 = dot(e1, e2), e22 = dot(e2, e2), w1 = dot(w, e1), w2 = dot(w, e2);
        const Affine gram = e11 * e22 - e12 * e12;
        result.push_back({t, (e22 * w1 - e12 * w2) / gram, (e11 * w2 - e12 * w1) / gram});
        const Affine square = dot(doubled, doubled);
        result.push_back({t, dot(cross(w, e2), doubled) / square, dot(cross(e1, w), doubled) / square});
        ways.next();
    }
    return result;
}

/// Question 9: from two edges at A, from the same normalized, and from two edges at B.
std::vector<AffineVec3> triangle_normals(const Triangle<Affine>& triangle, Roundings& roundings) {
    const AffineVec3 e1 = triangle.B - triangle.A;
    const AffineVec3 e2 = triangle.C - triangle.A;
    Alternatives ways(roundings);
    std::vector<AffineVec3> result{unit_vector(cross(e1, e2))};
    ways.next();
    result.push_back(unit_vector(cross(unit_vector(e1), unit_vector(e2))));
    ways.next();
    result.push_back(unit_vector(cross(e1, AffineVec3(triangle.C - triangle.B))));
    return result;
}

}  // namespace

TriangleBranch branch_of(const TriangleAnswers<Certified>& triangle) {
    return {triangle.t.has_value()};
}

void add_without_ray(const Triangle<Affine>& triangle, Roundings& roundings, Hulls& hulls) {
    for (const AffineVec3& normal : triangle_normals(triangle, roundings)) hulls.add(item::triangle::normal, normal);
}

void add_for_ray(const AffineRay& ray, const Triangle<Affine>& triangle, const TriangleBranch& branch,
                 Roundings& roundings, Hulls& hulls) {
    const LinearSystem<Affine> system = triangle_system(ray.start, ray.V, triangle);
    hulls.add(item::triangle::matrix, system.matrix);
    hulls.add(item::triangle::rhs, system.rhs);
    if (!branch.has_solution) return;
    const std::vector<AffineVec3> solutions = triangle_solutions(system, roundings);
    Alternatives ways(roundings);
    for (const AffineVec3& solution : solutions) {
        const auto& [t, u, v] = std::tie(solution.x, solution.y, solution.z);
        hulls.add(item::triangle::t, t);
        hulls.add(item::triangle::u, u);
        hulls.add(item::triangle::v, v);
        hulls.add(item::triangle::hit, point_on_ray(ray.start, ray.V, t));
        hulls.add(item::triangle::hit, triangle.A + scaled(system.matrix[1], u) + scaled(system.matrix[2], v));
        hulls.add(item::triangle::hit,
                  scaled(triangle.A, sum(Affine(1), -u, -v)) + scaled(triangle.B, u) + scaled(triangle.C, v));
        ways.next();
    }
}

std::vector<Reason> reasons_of(const Triangle<double>& triangle, const TriangleAnswers<double>& answers,
                               const CameraAnswers<double>& /*camera*/) {
    std::vector<Reason> reasons;
    const Mat3<double>& M = answers.system.matrix;
    const double narrow = narrowness(M[1], M[2]);
    const double edge = std::min(length(M[1]), length(M[2]));
    reasons.push_back({narrow * narrow, "the triangle is narrow", "Move a vertex"});
    reasons.push_back(
        {length(triangle.A) / edge, "an edge of the triangle is short compared with its coordinates", "Move a vertex"});
    reasons.push_back({1 / std::abs(dot(normalized(M[0]), normalized(cross(M[1], M[2])))),
                       "the ray is almost parallel to the triangle's plane",
                       "Choose another pixel or turn the triangle"});
    return reasons;
}

}  // namespace reference
