// Ray and triangle without a wrong decision: a static error filter on plain doubles, here and inline, and whole numbers
// for the few rays that it leaves open.
#pragma once

#include "reference/kernel/ray.h"

namespace reference::kernel {

/// Cramer's rule in doubles with det > 0, and how far its numbers may be off: u, v, w = 1 - u - v and t times det.
///
/// With u = 2^-53 and n = |B-A|₁ + |C-A|₁ + |S-A|₁, while nothing underflows: det, U and V are sums of products of
/// three factors, off by at most 7u of the product of the factors' norms, and these three products add up to |V|₁n²/3
/// at most; W is off by 3u|V|₁n² and T by un³. An underflow costs at most 2^-1072 (|V|₁ + n + 1). The bounds are
/// 16u(|V|₁ + k)(n + k)² and 16u(n + k)³ with k = 2^-300, which hold all of that and what computing them loses. Where
/// anything overflows they are infinite, and of a NaN, a zero direction or a triangle without an area nothing is
/// decided. For floats k changes nothing, unless n is 0.
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
        const double signed_det = -dot(d, normal);
        const double u = dot(side, q);
        const double v = -dot(side, p);
        const double w = signed_det - u - v;
        det = std::abs(signed_det);
        t = std::copysign(1.0, signed_det) * dot(s, normal);
        inside = signed_det < 0 ? -std::max(u, std::max(v, w)) : std::min(u, std::min(v, w));
        constexpr double k = 0x1p-300;
        const double n = size(p) + size(q) + size(s) + k;
        const double n_squared = n * n;
        error = n_squared * ((size(d) + k) * 16) * 0x1p-53;
        t_error = n_squared * (n * 16) * 0x1p-53;
    }

    bool is_miss() const { return (inside < -error) | (t < -t_error); }
    bool is_hit() const { return (inside > error) & (t > t_error); }
    /// is_hit() or is_miss() holds, and tells the truth.
    bool is_known() const { return (det > error) & (is_miss() | is_hit()); }
    /// Beside that: of a hit, det and T are known to 2^-28 of themselves, and so t = T / det to 2^-27.
    bool is_known_with_t() const {
        const bool t_known = (det > 0x1p28 * error) & (t > 0x1p28 * t_error) & (t_of_hit() > 0x1p-1000);
        return (det > error) & (is_miss() | (is_hit() & t_known));
    }
    double t_of_hit() const { return t / det; }

  private:
    static double size(const Vec3<double>& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }
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
