#include "reference/kernel/triangle.h"

#include <optional>

#include "reference/kernel/double_double.h"
#include "reference/kernel/exact.h"
#include "reference/stages/triangle.h"

namespace reference::kernel {
namespace {

Triangle<Dyadic> exact(const Triangle<double>& triangle) {
    return {over<Dyadic>(triangle.A), over<Dyadic>(triangle.B), over<Dyadic>(triangle.C)};
}

CramerSolution<Dyadic> exact_solution(const Ray<double>& ray, const Triangle<double>& triangle) {
    return solve_by_cramer(triangle_system(over<Dyadic>(ray.origin), over<Dyadic>(ray.direction), exact(triangle)));
}

bool has_area(const Triangle<Dyadic>& triangle) {
    const Vec3<Dyadic> normal = cross(Vec3<Dyadic>(triangle.B - triangle.A), Vec3<Dyadic>(triangle.C - triangle.A));
    return sign_of(normal.x) != 0 || sign_of(normal.y) != 0 || sign_of(normal.z) != 0;
}

/// Cramer's rule in double-double, and bounds of its errors. With the n of TriangleFilter, an error is at most 24u² of
/// |V|₁n², or of n³ for t (summing the bounds of double_double.h); 16 * 32u² is far more.
struct TriangleLevel {
    CramerSolution<DoubleDouble> solution;
    double error;
    double t_error;
    bool in_range;  ///< no product could leave the range of doubles

    TriangleLevel(const Ray<double>& ray, const Triangle<double>& triangle)
        : solution(solve_by_cramer(
              triangle_system(over<DoubleDouble>(ray.origin), over<DoubleDouble>(ray.direction),
                              Triangle<DoubleDouble>{over<DoubleDouble>(triangle.A), over<DoubleDouble>(triangle.B),
                                                     over<DoubleDouble>(triangle.C)}))) {
        constexpr double unit = 0x1p-101;
        const auto norm = PreparedTriangle<double>::norm;
        const double d = norm(ray.direction);
        const double n = PreparedTriangle<double>(triangle).edges + norm(ray.origin - triangle.A);
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

}  // namespace

TriangleResult decide_exactly(const Ray<double>& ray, const Triangle<double>& triangle) {
    if (!is_valid(ray) || !is_finite(triangle.A) || !is_finite(triangle.B) || !is_finite(triangle.C)) {
        return TriangleResult::invalid;
    }
    const CramerSolution<Dyadic> solution = exact_solution(ray, triangle);
    if (sign_of(solution.det) == 0 && !has_area(exact(triangle))) return TriangleResult::degenerate;
    switch (classify(solution)) {
        case reference::TriangleHit::hit:
        case reference::TriangleHit::boundary: return TriangleResult::hit;
        case reference::TriangleHit::coplanar: return TriangleResult::coplanar;
        case reference::TriangleHit::miss:
        case reference::TriangleHit::parallel:
        case reference::TriangleHit::unsure: break;
    }
    return TriangleResult::miss;
}

HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Triangle<double>& triangle) {
    return fraction_of(exact_solution(ray, triangle));
}

TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleResult result = decide(ray, triangle);
    if (!is_hit(result)) return {result, 0, 0, 0};
    const TriangleLevel level(ray, triangle);
    if (level.in_range) {
        const auto& [det, t_numerator, u_numerator, v_numerator] = level.solution;
        const auto t = quotient(t_numerator, det, level.t_error, level.error);
        const auto u = quotient(u_numerator, det, level.error, level.error);
        const auto v = quotient(v_numerator, det, level.error, level.error);
        if (t && u && v) return {result, *t, *u, *v};
    }
    const CramerSolution<Dyadic> exact = exact_solution(ray, triangle);
    const auto over_det = [&](const Dyadic& numerator) {
        return nearest(reference::Fraction<Dyadic>{numerator, exact.det});
    };
    return {result, over_det(exact.t_numerator), over_det(exact.u_numerator), over_det(exact.v_numerator)};
}

TriangleResult decide_exactly(const Ray<float>& ray, const Triangle<float>& triangle) {
    return decide_exactly(as_double(ray), as_double(triangle));
}

TriangleHit intersect(const Ray<float>& ray, const Triangle<float>& triangle) {
    return intersect(as_double(ray), as_double(triangle));
}

}  // namespace reference::kernel
