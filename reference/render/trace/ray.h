// The rays of a picture, and what a hit with an object is.
#pragma once

#include "reference/kernel/cylinder.h"
#include "reference/kernel/sphere.h"
#include "reference/render/scene/prepared_scene.h"
#include "reference/render/trace/start.h"

namespace reference::render {

/// The first hit with an object. t is known to a relative error of 2^-26.
struct ObjectHit {
    bool is_hit = false;
    bool from_inside = false;  ///< of a sphere or a cylinder: the ray comes from inside
    double t = 0;
    kernel::CylinderPart part = kernel::CylinderPart::tube;  ///< of a cylinder
};

/// A ray of the camera. A hit at t = 0 counts as the scene's boundary says.
struct CameraRay {
    kernel::Ray<double> ray;
};

inline double uncertainty_of(const CameraRay&) {
    return 0;
}
inline double uncertainty_of(const SurfaceRay& ray) {
    return ray.start.uncertainty;
}

inline Boundary boundary_of(const PreparedScene& scene, const CameraRay& /*ray*/) {
    return scene.boundary;
}
/// A surface ray has left the object that it starts on.
inline Boundary boundary_of(const PreparedScene& /*scene*/, const SurfaceRay& /*ray*/) {
    return Boundary::positive;
}

/// Let the start be off by `by`, summed over its coordinates. Then c changes by at most (2|f|₁ + by) by, and D by 2a
/// times that. More than that, in the filter's unit of 2^-48, is added to m.
KERNEL_INLINE void allow_for_start(kernel::SphereFilter& filter, const SurfaceRay& ray, const Sphere<double>& sphere) {
    const double by = ray.start.uncertainty;
    if (by == 0) return;
    const double f = kernel::PreparedTriangle<double>::norm(ray.ray.origin - sphere.center);
    const double more = 1 + 0x1p48 * (4 * f + 2 * by) * by * (1 + 0x1p-40) / filter.m;
    filter.m *= more;
    filter.am *= more;
}
KERNEL_INLINE void allow_for_start(kernel::SphereFilter& /*filter*/, const CameraRay& /*ray*/,
                                   const Sphere<double>& /*sphere*/) {}

}  // namespace reference::render
