// What exact decisions about a ray start from.
#pragma once

#include "reference/kernel/exact.h"
#include "reference/render/ray.h"

namespace reference::render {

using kernel::Dyadic;

inline Vec3<Dyadic> exact(const Vec3<double>& p) {
    return {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)};
}
inline Triangle<Dyadic> exact(const Triangle<double>& triangle) {
    return {exact(triangle.A), exact(triangle.B), exact(triangle.C)};
}
inline Sphere<Dyadic> exact(const Sphere<double>& sphere) {
    return {exact(sphere.center), Dyadic(sphere.radius)};
}

inline Vec3<Dyadic> exact_start(const PreparedScene& scene, const Ray& ray) {
    if (!ray.start) return exact(ray.ray.origin);
    if (scene.kind_of(ray.start->object) != ObjectKind::triangle) return exact(ray.start->point);
    const auto [A, B, C] = exact(scene.triangle(ray.start->object).triangle);
    return A + scaled(Vec3<Dyadic>(B - A), Dyadic(ray.start->u)) + scaled(Vec3<Dyadic>(C - A), Dyadic(ray.start->v));
}

}  // namespace reference::render
