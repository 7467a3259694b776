// What exact decisions about a camera ray or a surface ray start from.
#pragma once

#include "reference/render/scene/prepared_scene.h"
#include "reference/render/trace/dyadic.h"
#include "reference/render/trace/ray.h"

namespace reference::render {

inline Vec3<Dyadic> exact(const Vec3<double>& p) {
    return {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)};
}
inline Triangle<Dyadic> exact(const Triangle<double>& triangle) {
    return {exact(triangle.A), exact(triangle.B), exact(triangle.C)};
}
inline Sphere<Dyadic> exact(const Sphere<double>& sphere) {
    return {exact(sphere.center), Dyadic(sphere.radius)};
}

inline Vec3<Dyadic> exact_start(const PreparedScene& /*scene*/, const CameraRay& ray) {
    return exact(ray.ray.origin);
}
inline Vec3<Dyadic> exact_start(const PreparedScene& scene, const SurfaceRay& ray) {
    if (scene.kind_of(ray.start.object) != ObjectKind::triangle) return exact(ray.start.point);
    const auto [A, B, C] = exact(scene.triangle(ray.start.object).triangle);
    return A + scaled(Vec3<Dyadic>(B - A), Dyadic(ray.start.u)) + scaled(Vec3<Dyadic>(C - A), Dyadic(ray.start.v));
}

inline bool is_own(const CameraRay& /*ray*/, std::uint32_t /*object*/) {
    return false;
}
inline bool is_own(const SurfaceRay& ray, std::uint32_t object) {
    return ray.start.object == object;
}

}  // namespace reference::render
