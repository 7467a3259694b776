// Ray and triangle without a wrong decision: a static error filter on plain doubles, here and inline, and whole numbers
// for the few rays that it leaves open.
#pragma once

#include "reference/kernel/ray.h"

namespace reference::kernel {

/// Cramer's rule in doubles with det > 0, and how far its numbers may be off: u, v, w = 1 - u - v and t times det.
///
/// With u = 2^-53 and n = |B-A|₁ + |C-A|₁ + |S-A|₁, while nothing underflows: det, U and V are sums of products of
/// three factors, off by at most 7u of the product of the factors' norms, and these three products add up to |V|₁n²/3
/// at most; W is off by 3u|V|₁n² and T by un³. The bounds are 16u|V|₁n² and 16un³, which hold what computing them loses
/// too. Floats stay far inside the range of doubles. With doubles an underflow costs at most 2^-1072 (|V|₁ + n + 1):
/// k = 2^-300 added to |V|₁ and n holds that; and sizes beyond 2^300, where a product could overflow, make the bounds
/// infinite. Of a NaN, an infinity, a zero direction or a triangle without an area nothing is known.
struct TriangleFilter {
    double det;
    double t;
    double inside;  ///< the least of u, v and w
    double error;
    double t_error;

    template <class T>
    TriangleFilter(const Ray<T>& ray, const Triangle<T>& triangle) {
        const Vec3<double> d(ray.direction);
        const Vec3<double> A(triangle.A);
        const Vec3<double> p = Vec3<double>(triangle.B) - A;
        const Vec3<double> q = Vec3<double>(triangle.C) - A;
        const Vec3<double> s = Vec3<double>(ray.origin) - A;
        const Vec3<double> normal = cross(p, q);
        const Vec3<double> side = cross(s, d);
        const double det_or_minus = dot(d, normal);
        const double towards = std::copysign(1.0, det_or_minus);
        det = std::abs(det_or_minus);
        t = towards * dot(s, normal);
        const double u = towards * dot(side, q);
        const double v = towards * dot(side, p);
        inside = std::min(std::min(-u, v), det + u - v);
        double n = size(p) + size(q) + size(s);
        double d_size = size(d);
        if constexpr (std::is_same_v<T, double>) {
            constexpr double k = 0x1p-300;
            n += k;
            d_size += k;
            if (!(n + d_size < 0x1p300)) n = HUGE_VAL;
        }
        const double unit = 0x1p-49 * (n * n);
        error = unit * d_size;
        t_error = unit * n;
        t = -t;
    }

    /// The signs of all of them are, or of a triangle that is missed at least enough.
    bool is_known() const { return det > error && std::abs(inside) > error && std::abs(t) > t_error; }
    /// If it is known.
    bool is_hit() const { return (sign(inside) | sign(t)) == 0; }
    /// Beside that: of a hit, det and T are known to 2^-28 of themselves, and so t = T / det to 2^-27.
    bool is_known_with_t() const {
        return det > 0x1p28 * error && std::abs(inside) > error && std::abs(t) > 0x1p28 * t_error;
    }
    double t_of_hit() const { return t / det; }

  private:
    static double size(const Vec3<double>& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }
    static std::uint64_t sign(double x) { return std::bit_cast<std::uint64_t>(x) >> 63U; }
};

/// What the filter cannot tell, and whatever else: exact, and slower.
TriangleResult decide_exactly(const Ray<double>& ray, const Triangle<double>& triangle);

/// Exact; an edge that two triangles share is never missed between them. Never over- or underflows.
template <class T>
TriangleResult decide(const Ray<T>& ray, const Triangle<T>& triangle) {
    const TriangleFilter filter(ray, triangle);
    if (!filter.is_known()) [[unlikely]]
        return decide_exactly(as_double(ray), as_double(triangle));
    return filter.is_hit() ? TriangleResult::hit : TriangleResult::miss;
}

/// decide(), with t, u and v.
TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle);
inline TriangleHit intersect(const Ray<float>& ray, const Triangle<float>& triangle) {
    return intersect(as_double(ray), as_double(triangle));
}

/// decide(), with t as far as a float goes.
template <class T>
FloatHit<TriangleResult> intersect_to_float(const Ray<T>& ray, const Triangle<T>& triangle) {
    const TriangleFilter filter(ray, triangle);
    if (!filter.is_known_with_t()) [[unlikely]] {
        const TriangleResult result = decide(ray, triangle);
        if (result != TriangleResult::hit) return {result, 0};
        return {result, intersect(ray, triangle).t};
    }
    const bool hit = filter.is_hit();
    return {hit ? TriangleResult::hit : TriangleResult::miss, hit ? filter.t_of_hit() : 0};
}

}  // namespace reference::kernel
