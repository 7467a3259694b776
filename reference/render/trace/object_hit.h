// Whether a camera ray or a surface ray hits an object, without a wrong decision: the kernel's filters, inline in this
// file, and exact numbers for the few rays that the filters leave open.
#pragma once

#include "reference/kernel/triangle.h"
#include "reference/render/trace/cylinder_hit.h"

namespace reference::render {

/// Of a sphere or a triangle.
ObjectHit exact_hit(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object);
ObjectHit exact_hit(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object);
/// The order of the t's of two objects that are hit.
std::partial_ordering order_exactly(const PreparedScene& scene, const CameraRay& ray, std::uint32_t one,
                                    std::uint32_t other);
std::partial_ordering order_exactly(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t one,
                                    std::uint32_t other);
/// Whether an object that is hit is hit at t < 1.
bool is_hit_before_end(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object);
bool is_hit_before_end(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object);

KERNEL_INLINE void allow_for_start(kernel::TriangleFilter& filter, const SurfaceRay& ray, double edges) {
    allow_for_start(filter, ray.ray.direction, ray.start.uncertainty, edges);
}
KERNEL_INLINE void allow_for_start(kernel::TriangleFilter& /*filter*/, const CameraRay& /*ray*/, double /*edges*/) {}

template <class AnyRay>
KERNEL_INLINE ObjectHit hit_sphere(const PreparedScene& scene, const AnyRay& ray, const Sphere<double>& sphere,
                                   std::uint32_t object) {
    kernel::SphereFilter filter(ray.ray, sphere);
    allow_for_start(filter, ray, sphere);
    if (!filter.is_known(kernel::SphereFilter::margin_for_t)) [[unlikely]]
        return exact_hit(scene, ray, object);
    if (!filter.is_hit()) return {};
    return {true, filter.c < 0, filter.root()};
}

template <class AnyRay>
KERNEL_INLINE ObjectHit hit_triangle(const PreparedScene& scene, const AnyRay& ray,
                                     const kernel::PreparedTriangle<double>& triangle, std::uint32_t object) {
    kernel::TriangleFilter filter(ray.ray, triangle);
    allow_for_start(filter, ray, triangle.edges);
    if (!filter.is_known_with_t()) [[unlikely]] {
        if (filter.det > filter.error && filter.inside < -filter.error) return {};
        return exact_hit(scene, ray, object);
    }
    if (!filter.is_hit()) return {};
    return {true, false, filter.t()};
}

template <class AnyRay>
KERNEL_INLINE ObjectHit hit_object(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: return hit_sphere(scene, ray, scene.spheres[object], object);
        case ObjectKind::triangle: return hit_triangle(scene, ray, scene.triangle(object), object);
        case ObjectKind::cylinder: break;
    }
    return hit_cylinder(scene, ray, object);
}

inline ObjectHit hit_own_sphere(const PreparedScene& scene, const SurfaceRay& ray) {
    const Vec3<double>& d = ray.ray.direction;
    const double h = dot(d, Vec3<double>(ray.ray.origin - scene.spheres[ray.start.object].center));
    // For a grazing ray, rounding may point it outside. It then leaves the sphere at its start.
    return {true, true, h < 0 ? -2 * h / dot(d, d) : 0};
}

/// The hit of a ray with the object that it starts on. Only a sphere or a cylinder can be hit again, from inside.
inline ObjectHit hit_own(const PreparedScene& scene, const SurfaceRay& ray) {
    if (!ray.start.is_inside) return {};
    switch (scene.kind_of(ray.start.object)) {
        case ObjectKind::sphere: return hit_own_sphere(scene, ray);
        case ObjectKind::triangle: return {};
        case ObjectKind::cylinder: break;
    }
    return hit_own_cylinder(scene, ray);
}

}  // namespace reference::render
