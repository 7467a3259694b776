// Ray and sphere without a wrong decision: a static error filter on doubles, inline in this file, and exact numbers for
// the few rays that the filter leaves open.
#pragma once

#include "reference/kernel/exact.h"
#include "reference/kernel/ray.h"

namespace reference::kernel {

/// a t² + 2 h t + c = 0 in doubles, D = h² - a c, and how far off c and D may be.
///
/// With u = 2^-53, f = origin - center and m = |f|² + R², while nothing underflows: c is off by at most 7.02um and D by
/// 23uam, and the bounds 32um and 32uam also cover their own rounding (proven in sphere.g). An underflow costs c and D
/// at most 2^-1070 (a + m + 1): k = 2^-500 added to a and m covers that. Where anything overflows, D's bound overflows
/// first. For a NaN, an infinity, a zero direction or a radius that is not above 0, nothing is known.
struct SphereFilter {
    double a;
    double h;
    double c;
    double D;
    double m;
    double am;  ///< a m times overflow_room
    bool valid_radius;

    KERNEL_INLINE SphereFilter(const Ray<double>& ray, const Sphere<double>& sphere) {
        const Vec3<double>& d = ray.direction;
        const Vec3<double> f = ray.origin - sphere.center;
        a = dot(d, d);
        h = dot(d, f);
        const double f_squared = dot(f, f);
        const double R_squared = sphere.radius * sphere.radius;
        c = f_squared - R_squared;
        D = h * h - a * c;
        constexpr double k = 0x1p-500;
        m = f_squared + R_squared + k;
        am = (overflow_room * m) * (a + k);
        valid_radius = sphere.radius > 0;
    }

    /// Whether c and D are known to a relative error of 1/margin, and the ray and the sphere are valid. If so, h² = D +
    /// a c > 11uam for a c > 0 and D > 0, so the sign of h is known as well.
    bool is_known(double margin) const {
        return D_is_known(margin) && std::abs(c) > (margin * 0x1p-48) * m && valid_radius;
    }
    bool D_is_known(double margin) const { return std::abs(D) > (margin * (0x1p-48 / overflow_room)) * am; }
    /// Requires is_known(1): D > 0, and c < 0 or h < 0.
    bool is_hit() const { return D > 0 && (c < 0 || h < 0); }
    /// Requires is_known(margin_for_t). For a hit it is the root for t, in a form without cancellation; for a miss it
    /// is some number, not NaN. As c and D are known to a relative error of 2^-28, t is known to 2^-27 (sphere.g).
    double root() const {
        const double q = std::abs(h) + std::sqrt(std::abs(D));
        const bool from_inside = c < 0 && h < 0;
        return (from_inside ? q : std::abs(c)) / (from_inside ? a : q);
    }
    static constexpr double margin_for_t = 0x1p28;

  private:
    static constexpr double overflow_room = 0x1p4;
};

/// For a ray that may start anywhere within `uncertainty` of its origin, summed over the coordinates, and goes from
/// `from_center`, its origin seen from the sphere's center. c changes by at most (2|f|₁ + uncertainty) uncertainty, and
/// D by 2a times that. More than that, in the filter's unit of 2^-48, is added to m.
inline void allow_for_start(SphereFilter& filter, const Vec3<double>& from_center, double uncertainty) {
    if (uncertainty == 0) return;
    const double f = std::abs(from_center.x) + std::abs(from_center.y) + std::abs(from_center.z);
    const double more = 1 + 0x1p48 * (4 * f + 2 * uncertainty) * uncertainty * (1 + 0x1p-40) / filter.m;
    filter.m *= more;
    filter.am *= more;
}

/// Decides every case exactly, including those that the filter leaves open, but slower.
SphereResult decide_exactly(const Ray<double>& ray, const Sphere<double>& sphere);

/// Exact. Throws nothing, never over- or underflows.
KERNEL_INLINE SphereResult decide(const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereFilter filter(ray, sphere);
    if (!filter.is_known(1)) [[unlikely]]
        return decide_exactly(ray, sphere);
    return filter.is_hit() ? SphereResult::hit : SphereResult::miss;
}

/// decide(), with t.
SphereHit intersect(const Ray<double>& ray, const Sphere<double>& sphere);

/// The t of a sphere that is hit.
HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Sphere<double>& sphere);

/// decide(), with t to the accuracy of FloatHit.
KERNEL_INLINE FloatHit<SphereResult> intersect_to_float(const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereFilter filter(ray, sphere);
    if (!filter.is_known(SphereFilter::margin_for_t)) [[unlikely]] {
        const SphereHit hit = intersect(ray, sphere);
        return {hit.result, hit.t};
    }
    return filter.is_hit() ? FloatHit<SphereResult>{SphereResult::hit, filter.root()}
                           : FloatHit<SphereResult>{SphereResult::miss, 0};
}

}  // namespace reference::kernel
