// Which of a scene's objects a ray hits first, without a wrong decision.
#pragma once

#include <vector>

#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace reference::kernel {

/// The object hit at the smallest t >= 0.
struct First {
    enum class Kind {
        sphere,
        triangle,
        tie,      ///< two objects or more are hit at the same t exactly, and none before them
        none,     ///< nothing is hit
        invalid,  ///< the ray or one of the objects is invalid
    };
    Kind kind;
    std::size_t index;  ///< among the spheres or the triangles; 0 for tie, none and invalid
};

struct Cast {
    std::vector<SphereHit> spheres;
    std::vector<TriangleHit> triangles;
    First first;
};

/// Every object on its own, and the first of them. Writes into `result`, whose memory it keeps from ray to ray.
void cast_ray(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
              const std::vector<Triangle<double>>& triangles, Cast& result);

/// The same for one sphere and one triangle, with the first t as far as a float goes; 0 for none and invalid.
struct FirstHit {
    First::Kind kind;
    double t;
};
/// The sign of (the sphere's t) - (the triangle's t), both hit. Exact, and slow.
std::partial_ordering order_exactly(const Ray<double>& ray, const Sphere<double>& sphere,
                                    const Triangle<double>& triangle);

/// With the two t's each known to 2^-26, a difference of 2^-24 of the larger decides.
template <class T>
KERNEL_INLINE FirstHit first_of(const Ray<T>& ray, const Sphere<T>& sphere, const PreparedTriangle<T>& triangle) {
    const auto at_sphere = intersect_to_float(ray, sphere);
    const auto at_triangle = intersect_to_float(ray, triangle);
    if (at_sphere.result == SphereResult::invalid || at_triangle.result == TriangleResult::invalid) {
        return {First::Kind::invalid, 0};
    }
    const FirstHit sphere_first{First::Kind::sphere, at_sphere.t};
    const FirstHit triangle_first{First::Kind::triangle, at_triangle.t};
    if (at_sphere.result == SphereResult::miss) {
        return at_triangle.result == TriangleResult::hit ? triangle_first : FirstHit{First::Kind::none, 0};
    }
    if (at_triangle.result != TriangleResult::hit) return sphere_first;
    const double difference = at_sphere.t - at_triangle.t;
    const double larger = std::max(at_sphere.t, at_triangle.t);
    if (!(std::abs(difference) > 0x1p-24 * larger + 0x1p-1000) || std::isinf(larger)) [[unlikely]] {
        const auto order = order_exactly(as_double(ray), as_double(sphere), as_double(triangle.triangle));
        if (order == 0) return {First::Kind::tie, at_sphere.t};
        return order < 0 ? sphere_first : triangle_first;
    }
    return difference < 0 ? sphere_first : triangle_first;
}

template <class T>
KERNEL_INLINE FirstHit first_of(const Ray<T>& ray, const Sphere<T>& sphere, const Triangle<T>& triangle) {
    return first_of(ray, sphere, PreparedTriangle<T>(triangle));
}

}  // namespace reference::kernel
