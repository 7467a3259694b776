// Ray and triangle without a wrong decision: a static error filter on doubles, inline in this file, and exact numbers
// for the few rays that the filter leaves open.
#pragma once

#include <algorithm>

#include "reference/kernel/exact.h"
#include "reference/kernel/ray.h"

namespace reference::kernel {

/// The part of the filter that depends on the triangle alone. Computed once, it serves many rays.
struct PreparedTriangle {
    Triangle<double> triangle;
    Vec3<double> p;  ///< B - A
    Vec3<double> q;  ///< C - A
    Vec3<double> normal;
    double edges;  ///< |p|₁ + |q|₁ + 2^-300

    KERNEL_INLINE explicit PreparedTriangle(const Triangle<double>& given)
        : triangle(given),
          p(given.B - given.A),
          q(given.C - given.A),
          normal(cross(p, q)),
          edges(norm(p) + norm(q) + 0x1p-300) {}

    static double norm(const Vec3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }
};

/// Cramer's rule in doubles, with the signs turned so that det > 0: det, and u, v, w = 1 - u - v and t, each times det.
/// Also bounds of their errors.
///
/// With u = 2^-53, e = |B-A|₁ + |C-A|₁ and n = e + |S-A|₁, while nothing underflows: det, U, V and W are off by at most
/// 9.02u|V|₁en and T by 8.02ue²n, and the bounds 16u|V|₁en and 16ue²n also cover their own rounding (proven in
/// triangle.g). An underflow costs at most 2^-1071 (|V|₁ + n + 1): k = 2^-300 added to |V|₁ and e, and so to n, covers
/// that; and sizes beyond 2^300, where a product could overflow, make the bounds infinite. For a NaN, an infinity, a
/// zero direction or a triangle without area, nothing is known.
struct TriangleFilter {
    double det;
    double t_numerator;
    double inside;  ///< the least of u, v and w
    double error;
    double t_error;

    KERNEL_INLINE TriangleFilter(const Ray<double>& ray, const PreparedTriangle& triangle) {
        const Vec3<double>& d = ray.direction;
        const Vec3<double> s = ray.origin - triangle.triangle.A;
        const Vec3<double> side = cross(s, d);
        const double minus_det = dot(d, triangle.normal);
        const double towards = std::copysign(1.0, minus_det);
        det = std::abs(minus_det);
        t_numerator = -(towards * dot(s, triangle.normal));
        const double minus_u = towards * dot(side, triangle.q);
        const double v = towards * dot(side, triangle.p);
        inside = std::min(std::min(-minus_u, v), det + minus_u - v);
        const double e = triangle.edges;
        const double d_norm = triangle.norm(d) + k;
        double n = e + triangle.norm(s);
        if (!(n + d_norm < 0x1p300)) n = HUGE_VAL;
        const double unit = 0x1p-49 * e * n;
        error = unit * d_norm;
        t_error = unit * e;
    }

    /// Whether the deciding signs are known: the signs of det, of t and of the least of u, v and w.
    bool is_known() const { return det > error && std::abs(inside) > error && std::abs(t_numerator) > t_error; }
    /// Requires is_known().
    bool is_hit() const { return inside > 0 && t_numerator > 0; }
    /// Whether in addition T is known to a relative error of 2^-28. Then the det of a hit is, too: the hit point is at
    /// most e from A, so t|V|₁ <= n and det = T/t > 2^28 * 16ue²|V|₁, while det is off by at most 2u|V|₁e², which is
    /// less than 2^-30 of it. So t = T/det is known to 2^-27.
    bool is_known_with_t() const {
        return det > error && std::abs(inside) > error && std::abs(t_numerator) > 0x1p28 * t_error;
    }
    /// Requires is_known_with_t(). It is t for a hit; for a miss it is some number, not NaN.
    double t() const { return t_numerator / det; }

  private:
    static constexpr double k = 0x1p-300;
};

/// For a ray that may start anywhere within `uncertainty` of its origin, summed over the coordinates, at a triangle
/// with these `edges`. A start that is off by x changes u, v and w times det by at most x |V|₁e, and t times det by at
/// most x e².
KERNEL_INLINE void allow_for_start(TriangleFilter& filter, const Vec3<double>& direction, double uncertainty,
                                   double edges) {
    const double by = uncertainty * edges * (1 + 0x1p-40);
    filter.error += by * PreparedTriangle::norm(direction);
    filter.t_error += by * edges;
}

/// Decides every case exactly, including those that the filter leaves open, but slower.
TriangleResult decide_exactly(const Ray<double>& ray, const Triangle<double>& triangle);

/// Exact: no ray slips through between two triangles that share an edge. Never over- or underflows.
KERNEL_INLINE TriangleResult decide(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleFilter filter(ray, PreparedTriangle(triangle));
    if (!filter.is_known()) [[unlikely]]
        return decide_exactly(ray, triangle);
    return filter.is_hit() ? TriangleResult::hit : TriangleResult::miss;
}

/// decide(), with t, u and v.
TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle);

/// The t of a triangle that is hit.
HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Triangle<double>& triangle);

/// decide(), with t to the accuracy of FloatHit.
KERNEL_INLINE FloatHit<TriangleResult> intersect_to_float(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleFilter filter(ray, PreparedTriangle(triangle));
    if (!filter.is_known_with_t()) [[unlikely]] {
        const TriangleHit hit = intersect(ray, triangle);
        return {hit.result, hit.t};
    }
    return filter.is_hit() ? FloatHit<TriangleResult>{TriangleResult::hit, filter.t()}
                           : FloatHit<TriangleResult>{TriangleResult::miss, 0};
}

}  // namespace reference::kernel
