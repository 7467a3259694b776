// Ray and cylinder without a wrong decision. A ray is inside a cylinder where it is both within the tube and between
// the caps' planes, so it enters and leaves at a root of the tube's quadratic or at a cap's t. Signs alone decide
// which: of intervals of doubles, and of whole numbers for the few rays whose signs these leave open.
#pragma once

#include "reference/kernel/exact.h"
#include "reference/kernel/ray.h"
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

/// The t of a cylinder that is hit.
HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Cylinder<double>& cylinder);

/// Exact. Never over- or underflows.
CylinderHit intersect(const Ray<double>& ray, const Cylinder<double>& cylinder);

}  // namespace reference::kernel
