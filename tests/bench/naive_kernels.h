// What a certified kernel is measured against: the textbook's formulas, as a careful programmer without an error bound
// would write them.
#pragma once

#include "reference/kernel/ray.h"

namespace naive {

using reference::Vec3;
using reference::kernel::Ray;

/// The smaller root that is at least 0; -1 for a miss.
template <class S, class T>
S sphere_t(const Ray<T>& ray, const reference::Sphere<T>& sphere) {
    const Vec3<S> d(ray.direction);
    const Vec3<S> f = Vec3<S>(ray.origin) - Vec3<S>(sphere.center);
    const S R = static_cast<S>(sphere.radius);
    const S a = dot(d, d);
    const S b = 2 * dot(d, f);
    const S c = dot(f, f) - R * R;
    const S discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return -1;
    const S root = std::sqrt(discriminant);
    const S smaller = (-b - root) / (2 * a);
    if (smaller >= 0) return smaller;
    const S larger = (-b + root) / (2 * a);
    return larger >= 0 ? larger : -1;
}

/// Möller and Trumbore (1997), with one test at the end.
template <class S>
struct MollerTrumbore {
    S t;
    bool hit;

    template <class T>
    MollerTrumbore(const Ray<T>& ray, const reference::Triangle<T>& triangle) {
        const Vec3<S> d(ray.direction);
        const Vec3<S> A(triangle.A);
        const Vec3<S> p = Vec3<S>(triangle.B) - A;
        const Vec3<S> q = Vec3<S>(triangle.C) - A;
        const Vec3<S> s = Vec3<S>(ray.origin) - A;
        const Vec3<S> d_q = cross(d, q);
        const Vec3<S> s_p = cross(s, p);
        const S inverse = 1 / dot(p, d_q);
        const S u = dot(s, d_q) * inverse;
        const S v = dot(d, s_p) * inverse;
        t = dot(q, s_p) * inverse;
        hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0);
    }
};
template <class S, class T>
bool triangle_is_hit(const Ray<T>& ray, const reference::Triangle<T>& triangle) {
    return MollerTrumbore<S>(ray, triangle).hit;
}
/// -1 for a miss.
template <class S, class T>
S triangle_t(const Ray<T>& ray, const reference::Triangle<T>& triangle) {
    const MollerTrumbore<S> at(ray, triangle);
    return at.hit ? at.t : -1;
}

struct First {
    bool is_sphere;
    double t;
};
template <class S, class T>
First first(const Ray<T>& ray, const reference::Sphere<T>& sphere, const reference::Triangle<T>& triangle) {
    const auto at_sphere = static_cast<double>(sphere_t<S>(ray, sphere));
    const auto at_triangle = static_cast<double>(triangle_t<S>(ray, triangle));
    if (at_triangle < 0) return {true, at_sphere};
    if (at_sphere < 0) return {false, at_triangle};
    return at_sphere < at_triangle ? First{true, at_sphere} : First{false, at_triangle};
}

}  // namespace naive
