#include "reference/kernel/triangle.h"

#include "reference/exact/rational.h"
#include "reference/kernel/double_double.h"
#include "reference/kernel/integers.h"

namespace reference::kernel {
namespace {

double size(const Vec3<double>& p) {
    return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
}

/// A level of the kernel: Cramer's rule in S, and how far its results may be off. With u = 2^-53 and
/// n = |B-A|₁ + |C-A|₁ + |S-A|₁: in doubles det and the numerators of u and v are off by at most 16u|V|₁n², that of t
/// by 16un³. In double-double by 24u² of the same (summing the bounds of double_double.h), so with 32u² for u the same
/// holds.
template <class S>
struct Level {
    static constexpr double u = std::is_same_v<S, double> ? 0x1p-53 : 0x1p-101;
    CramerSolution<S> solution;
    double error;
    double t_error;
    bool in_range;  ///< no product could leave the range of doubles

    Level(const Ray<double>& ray, const Triangle<double>& triangle)
        : solution(solve_by_cramer(
              triangle_system(over<S>(ray.origin), over<S>(ray.direction),
                              reference::Triangle<S>{over<S>(triangle.A), over<S>(triangle.B), over<S>(triangle.C)}))) {
        const double d = size(ray.direction);
        const double n = size(triangle.B - triangle.A) + size(triangle.C - triangle.A) + size(ray.origin - triangle.A);
        error = 16 * u * d * n * n;
        t_error = 16 * u * n * n * n;
        in_range = 0x1p-300 < d && d < 0x1p300 && 0x1p-300 < n && n < 0x1p300;
    }

    /// Empty where a sign could not be told.
    std::optional<TriangleResult> decide() const {
        const auto det = static_cast<double>(solution.det);
        if (!in_range || !(std::abs(det) > error)) return std::nullopt;
        const auto towards = [&](const S& x) { return det < 0 ? -static_cast<double>(x) : static_cast<double>(x); };
        const double U = towards(solution.u_numerator);
        const double V = towards(solution.v_numerator);
        const double W = towards(solution.det - solution.u_numerator - solution.v_numerator);
        const double T = towards(solution.t_numerator);
        if (U < -error || V < -error || W < -error || T < -t_error) return TriangleResult::miss;
        if (U > error && V > error && W > error && T > t_error) return TriangleResult::hit;
        return std::nullopt;
    }
};

template <class I>
bool has_no_area(const reference::Triangle<I>& triangle) {
    const Vec3<I> normal = cross(Vec3<I>(triangle.B - triangle.A), Vec3<I>(triangle.C - triangle.A));
    return sign_of(normal.x) == 0 && sign_of(normal.y) == 0 && sign_of(normal.z) == 0;
}

TriangleResult decide_in_integers(const Ray<double>& ray, const Triangle<double>& triangle) {
    return in_integers(ray, {}, {triangle}, [](const auto& scene) {
        if (has_no_area(scene.triangles.front())) return TriangleResult::degenerate;
        switch (classify(solution_of(scene.ray, scene.triangles.front()))) {
            case reference::TriangleHit::hit:
            case reference::TriangleHit::boundary: return TriangleResult::hit;
            case reference::TriangleHit::coplanar: return TriangleResult::coplanar;
            case reference::TriangleHit::miss:
            case reference::TriangleHit::parallel:
            case reference::TriangleHit::unsure: break;  // unsure: not with whole numbers
        }
        return TriangleResult::miss;
    });
}

/// numerator / det, when both are known to 2^-57 of themselves.
std::optional<double> quotient(const DoubleDouble& numerator, const DoubleDouble& det, double error, double det_error) {
    const bool known = error < 0x1p-57 * std::abs(static_cast<double>(numerator)) &&
                       det_error < 0x1p-57 * std::abs(static_cast<double>(det));
    if (!known) return std::nullopt;
    return static_cast<double>(numerator / det);
}

/// numerator / det * 2^exponent, correctly rounded.
double exact_quotient(const Integer& numerator, const Integer& det, long exponent) {
    Rational x(numerator.value(), det.value());
    x.canonicalize();
    const auto bits = static_cast<mp_bitcnt_t>(std::abs(exponent));
    if (exponent < 0) {
        x >>= bits;
    } else {
        x <<= bits;
    }
    return enclose(x).nearest;
}

TriangleHit solve(const Ray<double>& ray, const Triangle<double>& triangle) {
    const Level<DoubleDouble> level(ray, triangle);
    const CramerSolution<DoubleDouble>& solution = level.solution;
    if (level.in_range) {
        const auto t = quotient(solution.t_numerator, solution.det, level.t_error, level.error);
        const auto u = quotient(solution.u_numerator, solution.det, level.error, level.error);
        const auto v = quotient(solution.v_numerator, solution.det, level.error, level.error);
        if (t && u && v) return {TriangleResult::hit, *t, *u, *v};
    }
    const IntegerScene<Integer> scene = as_integers<Integer>(scales_of(ray, {}, {triangle}), ray, {}, {triangle});
    const CramerSolution<Integer> exact = solution_of(scene.ray, scene.triangles.front());
    return {TriangleResult::hit, exact_quotient(exact.t_numerator, exact.det, scene.t_exponent),
            exact_quotient(exact.u_numerator, exact.det, 0), exact_quotient(exact.v_numerator, exact.det, 0)};
}

}  // namespace

TriangleResult decide(const Ray<double>& ray, const Triangle<double>& triangle) {
    if (!is_valid(ray) || !is_finite(triangle.A) || !is_finite(triangle.B) || !is_finite(triangle.C)) {
        return TriangleResult::invalid;
    }
    if (const auto result = Level<double>(ray, triangle).decide()) return *result;
    if (const auto result = Level<DoubleDouble>(ray, triangle).decide()) return *result;
    return decide_in_integers(ray, triangle);
}

TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleResult result = decide(ray, triangle);
    if (result != TriangleResult::hit) return {result, 0, 0, 0};
    return solve(ray, triangle);
}

}  // namespace reference::kernel
