// Ray and cylinder without a wrong decision: a static error filter on doubles, inline in this file, and exact numbers
// for the few rays that the filter leaves open. A ray is inside a cylinder where it is both within the tube and between
// the caps' planes, so it enters and leaves at a root of the tube's quadratic or at a cap's t.
#pragma once

#include <algorithm>

#include "reference/kernel/exact.h"
#include "reference/kernel/sphere.h"
#include "reference/stages/cylinder.h"

namespace reference::kernel {

/// hit, miss (also for a ray that runs along the tube's side; in a cap's plane it meets the rim, which is the tube's),
/// tangent to the tube, or invalid.
using CylinderResult = SphereResult;

/// The part that is hit. A cap is open and the tube closed, so the rim belongs to the tube.
enum class CylinderPart { tube, top, bottom };

/// t follows the rules of SphereHit::t.
struct CylinderHit {
    CylinderResult result;
    CylinderPart part;  ///< tube without a hit
    double t;
};

/// cylinder_equations() with both sides of the caps' doubled: a Dyadic has no division.
template <class S>
CylinderEquations<S> doubled_equations(const Vec3<S>& start, const Vec3<S>& V, const Cylinder<S>& cylinder) {
    const Vec3<S> from_center = start - cylinder.center;
    const S a = V.x * V.x + V.z * V.z;
    const S b = S(2) * (V.x * from_center.x + V.z * from_center.z);
    const S c = from_center.x * from_center.x + from_center.z * from_center.z - cylinder.radius * cylinder.radius;
    const S down = -(from_center.y + from_center.y);
    const S pace = V.y + V.y;
    return {{a, b, c, b * b - S(4) * a * c}, {down + cylinder.height, pace}, {down - cylinder.height, pace}};
}

/// The tube seen from above is a circle in the plane y = 0, which is that of a sphere.
KERNEL_INLINE SphereFilter seen_from_above(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const auto level = [](const Vec3<double>& p) { return Vec3<double>(p.x, 0, p.z); };
    return {{level(ray.origin), level(ray.direction)}, {level(cylinder.center), cylinder.radius}};
}

/// The t at which the ray's line enters and leaves the cylinder, in doubles.
///
/// The roots of the circle are known to 2^-27 (sphere.g). With u = 2^-53, the way to a cap's plane is off by at most
/// 2.01u(|start| + half), so beyond 2^-22(|start| + half) its t is known to 2^-27 (cylinder.g). A t above 2^-1000 has
/// not underflowed. Then a difference above 2^-24 of the smaller t decides which is larger, as in first.g.
struct CylinderFilter {
    double enter;  ///< any negative number if that is behind the start
    double leave;
    bool meets_tube;
    bool is_known;  ///< whether is_hit() and t() are right; false for invalid numbers

    KERNEL_INLINE CylinderFilter(const Ray<double>& ray, const Cylinder<double>& cylinder) {
        const SphereFilter circle = seen_from_above(ray, cylinder);
        const double root = circle.root();
        const double far = (std::abs(circle.h) + std::sqrt(std::abs(circle.D))) / circle.a;
        const double start = ray.origin.y - cylinder.center.y;
        const double half = cylinder.height / 2;
        const double up = half - start, down = -half - start;
        const double top = up / ray.direction.y, bottom = down / ray.direction.y;
        const bool inside = circle.c < 0;
        enter = std::max(inside ? -1 : root, std::min(top, bottom));
        leave = std::min(inside ? root : far, std::max(top, bottom));
        meets_tube = circle.is_hit();
        const double least = std::min(std::abs(enter), std::abs(leave));
        const bool apart = least > 0x1p-1000 && least < 0x1p1000 && std::abs(leave - enter) > 0x1p-24 * least;
        is_known = circle.is_known(SphereFilter::margin_for_t) && half > 0 && std::abs(ray.direction.y) < HUGE_VAL &&
                   std::min(std::abs(up), std::abs(down)) > 0x1p-22 * (std::abs(start) + half) + 0x1p-1000 &&
                   (apart || !meets_tube);
    }
    bool is_hit() const { return meets_tube && leave > 0 && enter < leave; }
    double t() const { return enter > 0 ? enter : leave; }
};

/// The t of a cylinder that is hit.
HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Cylinder<double>& cylinder);

/// Exact. Never over- or underflows.
CylinderHit intersect(const Ray<double>& ray, const Cylinder<double>& cylinder);

/// The same decision, with t to the accuracy of FloatHit.
KERNEL_INLINE FloatHit<CylinderResult> intersect_to_float(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const CylinderFilter filter(ray, cylinder);
    if (!filter.is_known) [[unlikely]] {
        const CylinderHit hit = intersect(ray, cylinder);
        return {hit.result, hit.t};
    }
    return filter.is_hit() ? FloatHit<CylinderResult>{CylinderResult::hit, filter.t()}
                           : FloatHit<CylinderResult>{CylinderResult::miss, 0};
}

}  // namespace reference::kernel
