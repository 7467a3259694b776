#include "reference/kernel/triangle.h"

#include "reference/kernel/double_double.h"
#include "reference/kernel/integers.h"
#include "reference/stages/triangle.h"

namespace reference::kernel {
namespace {

double size(const Vec3<double>& p) {
    return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
}

/// Cramer's rule in double-double, and bounds of its errors. With the n of TriangleFilter, an error is at most 24u² of
/// |V|₁n², or of n³ for t (summing the bounds of double_double.h); 16 * 32u² is far more.
struct TriangleLevel {
    CramerSolution<DoubleDouble> solution;
    double error;
    double t_error;
    bool in_range;  ///< no product could leave the range of doubles

    TriangleLevel(const Ray<double>& ray, const Triangle<double>& triangle)
        : solution(solve_by_cramer(triangle_system(
              over<DoubleDouble>(ray.origin), over<DoubleDouble>(ray.direction),
              reference::Triangle<DoubleDouble>{over<DoubleDouble>(triangle.A), over<DoubleDouble>(triangle.B),
                                                over<DoubleDouble>(triangle.C)}))) {
        constexpr double unit = 0x1p-101;
        const double d = size(ray.direction);
        const double n = size(triangle.B - triangle.A) + size(triangle.C - triangle.A) + size(ray.origin - triangle.A);
        error = 16 * unit * d * n * n;
        t_error = 16 * unit * n * n * n;
        in_range = 0x1p-300 < d && d < 0x1p300 && 0x1p-300 < n && n < 0x1p300;
    }
};

/// numerator / det, if both are known to a relative error of 2^-57.
std::optional<double> quotient(const DoubleDouble& numerator, const DoubleDouble& det, double error, double det_error) {
    const bool known = error < 0x1p-57 * std::abs(static_cast<double>(numerator)) &&
                       det_error < 0x1p-57 * std::abs(static_cast<double>(det));
    if (!known) return std::nullopt;
    return static_cast<double>(numerator / det);
}

struct Decision {
    TriangleResult result;
    bool is_at_start;  ///< a hit with t = 0, e.g. where the picture's plane is the triangle's plane
};

TriangleHit solve(const Ray<double>& ray, const Triangle<double>& triangle, bool is_at_start) {
    const TriangleLevel level(ray, triangle);
    const CramerSolution<DoubleDouble>& solution = level.solution;
    if (level.in_range) {
        const auto t =
            is_at_start ? std::optional(0.0) : quotient(solution.t_numerator, solution.det, level.t_error, level.error);
        const auto u = quotient(solution.u_numerator, solution.det, level.error, level.error);
        const auto v = quotient(solution.v_numerator, solution.det, level.error, level.error);
        if (t && u && v) return {TriangleResult::hit, *t, *u, *v};
    }
    const Scales scales(ray, triangle);
    const auto exact = determinants_of(Whole<Integer>(scales), ray, triangle);
    const Integer det = exact.det();
    return {TriangleResult::hit, exact_quotient(exact.t(), det, scales.exponent_of_t()),
            exact_quotient(exact.u(), det, 0), exact_quotient(exact.v(), det, 0)};
}

template <class N, class E>
Decision decision_of(const Determinants<N, E>& exact) {
    constexpr Decision miss{TriangleResult::miss, false};
    const auto det = exact.det();
    const auto det_sign = sign_of(det);
    if (det_sign == 0) {
        const auto normal = exact.normal();
        if (sign_of(normal.x) == 0 && sign_of(normal.y) == 0 && sign_of(normal.z) == 0) {
            return {TriangleResult::degenerate, false};
        }
        return {sign_of(exact.t()) == 0 ? TriangleResult::coplanar : TriangleResult::miss, false};
    }
    const auto is_negative = [&](const auto& x) { return det_sign > 0 ? sign_of(x) < 0 : sign_of(x) > 0; };
    const auto u = exact.u();
    if (is_negative(u)) return miss;
    const auto v = exact.v();
    if (is_negative(v) || is_negative(det - u - v)) return miss;
    const auto t = exact.t();
    if (is_negative(t)) return miss;
    return {TriangleResult::hit, sign_of(t) == 0};
}

/// Decides what the filter left open.
Decision decide_open(const Ray<double>& ray, const Triangle<double>& triangle) {
    if (!is_valid(ray) || !is_finite(triangle.A) || !is_finite(triangle.B) || !is_finite(triangle.C)) {
        return {TriangleResult::invalid, false};
    }
    const Scales scales(ray, triangle);
    if (!scales.are_near_one()) {
        const TriangleFilter filter(scales.to_one(ray), PreparedTriangle(scales.to_one(triangle)));
        if (filter.is_known()) return {filter.is_hit() ? TriangleResult::hit : TriangleResult::miss, false};
    }
    return in_whole_numbers(scales,
                            [&](const auto& whole) { return decision_of(determinants_of(whole, ray, triangle)); });
}

}  // namespace

TriangleResult decide_exactly(const Ray<double>& ray, const Triangle<double>& triangle) {
    return decide_open(ray, triangle).result;
}

TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleFilter filter(ray, PreparedTriangle(triangle));
    if (filter.is_known()) {
        return filter.is_hit() ? solve(ray, triangle, false) : TriangleHit{TriangleResult::miss, 0, 0, 0};
    }
    const auto [result, is_at_start] = decide_open(ray, triangle);
    if (result != TriangleResult::hit) return {result, 0, 0, 0};
    return solve(ray, triangle, is_at_start);
}

TriangleResult decide_exactly(const Ray<float>& ray, const Triangle<float>& triangle) {
    return decide_exactly(as_double(ray), as_double(triangle));
}

TriangleHit intersect(const Ray<float>& ray, const Triangle<float>& triangle) {
    return intersect(as_double(ray), as_double(triangle));
}

}  // namespace reference::kernel
