// Ray and triangle without a wrong decision: a static error filter on plain doubles, here and inline, and whole numbers
// for the few rays that it leaves open.
#pragma once

#include "reference/kernel/ray.h"

namespace reference::kernel {

/// What the filter takes of a triangle alone. Made once, it serves many rays.
template <class T>
struct PreparedTriangle {
    Triangle<T> triangle;
    Vec3<double> A;
    Vec3<double> p;  ///< B - A
    Vec3<double> q;  ///< C - A
    Vec3<double> normal;
    double edges;  ///< |p|₁ + |q|₁

    KERNEL_INLINE explicit PreparedTriangle(const Triangle<T>& given)
        : triangle(given),
          A(given.A),
          p(Vec3<double>(given.B) - A),
          q(Vec3<double>(given.C) - A),
          normal(cross(p, q)),
          edges(norm(p) + norm(q)) {}

    static double norm(const Vec3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }
};

/// Cramer's rule in doubles with det > 0, and how far its numbers may be off: u, v, w = 1 - u - v and t times det.
///
/// With u = 2^-53, e = |B-A|₁ + |C-A|₁ and n = e + |S-A|₁, while nothing underflows: det, U and V are sums of products
/// of three factors, off by at most 7u of the product of the factors' norms, and these three products add up to |V|₁en
/// at most; W is off by 9u|V|₁en and T by 8ue²n. The bounds are 16u|V|₁en and 16ue²n, which hold what computing them
/// loses too. Floats stay far inside the range of doubles. With doubles an underflow costs at most 2^-1072 (|V|₁ + n +
/// 1): k = 2^-300 added to |V|₁ and e holds that; and sizes beyond 2^300, where a product could overflow, make the
/// bounds infinite. Of a NaN, an infinity, a zero direction or a triangle without an area nothing is known.
struct TriangleFilter {
    double det;
    double t_numerator;
    double inside;  ///< the least of u, v and w
    double error;
    double t_error;

    template <class T>
    KERNEL_INLINE TriangleFilter(const Ray<T>& ray, const PreparedTriangle<T>& triangle) {
        const Vec3<double> d(ray.direction);
        const Vec3<double> s = Vec3<double>(ray.origin) - triangle.A;
        const Vec3<double> side = cross(s, d);
        const double minus_det = dot(d, triangle.normal);
        const double towards = std::copysign(1.0, minus_det);
        det = std::abs(minus_det);
        t_numerator = -(towards * dot(s, triangle.normal));
        const double minus_u = towards * dot(side, triangle.q);
        const double v = towards * dot(side, triangle.p);
        inside = std::min(std::min(-minus_u, v), det + minus_u - v);
        double e = triangle.edges;
        double d_norm = triangle.norm(d);
        double n = e + triangle.norm(s);
        if constexpr (std::is_same_v<T, double>) {
            constexpr double k = 0x1p-300;
            e += k;
            d_norm += k;
            n += k;
            if (!(n + d_norm < 0x1p300)) n = HUGE_VAL;
        }
        const double unit = 0x1p-49 * (e * n);
        error = unit * d_norm;
        t_error = unit * e;
    }

    /// The signs of all of them are, or of a triangle that is missed at least enough.
    bool is_known() const { return det > error && std::abs(inside) > error && std::abs(t_numerator) > t_error; }
    /// If it is known.
    bool is_hit() const { return (sign(inside) | sign(t_numerator)) == 0; }
    /// Beside that, T is known to 2^-28 of itself. So is the det of a hit: its point is at most e from A, so t|V|₁ <=
    /// n, and det = T/t > 2^28 * 16ue²|V|₁, of which the 2u|V|₁e² that det may be off is less than 2^-30. t = T/det is
    /// then known to 2^-27.
    bool is_known_with_t() const {
        return det > error && std::abs(inside) > error && std::abs(t_numerator) > 0x1p28 * t_error;
    }
    /// Of a hit that is known so; a number in any case.
    double t() const { return t_numerator / det; }

  private:
    static std::uint64_t sign(double x) { return std::bit_cast<std::uint64_t>(x) >> 63U; }
};

/// What the filter cannot tell, and whatever else: exact, and slower. Takes floats as they are, so that the fast path
/// has nothing to prepare for it.
TriangleResult decide_exactly(const Ray<double>& ray, const Triangle<double>& triangle);
TriangleResult decide_exactly(const Ray<float>& ray, const Triangle<float>& triangle);

/// Exact; an edge that two triangles share is never missed between them. Never over- or underflows.
template <class T>
KERNEL_INLINE TriangleResult decide(const Ray<T>& ray, const PreparedTriangle<T>& triangle) {
    const TriangleFilter filter(ray, triangle);
    if (!filter.is_known()) [[unlikely]]
        return decide_exactly(ray, triangle.triangle);
    return filter.is_hit() ? TriangleResult::hit : TriangleResult::miss;
}
template <class T>
KERNEL_INLINE TriangleResult decide(const Ray<T>& ray, const Triangle<T>& triangle) {
    return decide(ray, PreparedTriangle<T>(triangle));
}

/// decide(), with t, u and v.
TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle);
TriangleHit intersect(const Ray<float>& ray, const Triangle<float>& triangle);

/// decide(), with t as far as a float goes.
template <class T>
KERNEL_INLINE FloatHit<TriangleResult> intersect_to_float(const Ray<T>& ray, const PreparedTriangle<T>& triangle) {
    const TriangleFilter filter(ray, triangle);
    if (!filter.is_known_with_t()) [[unlikely]] {
        const TriangleHit hit = intersect(ray, triangle.triangle);
        return {hit.result, hit.t};
    }
    return {filter.is_hit() ? TriangleResult::hit : TriangleResult::miss, filter.t() * filter.is_hit()};
}
template <class T>
KERNEL_INLINE FloatHit<TriangleResult> intersect_to_float(const Ray<T>& ray, const Triangle<T>& triangle) {
    return intersect_to_float(ray, PreparedTriangle<T>(triangle));
}

}  // namespace reference::kernel
