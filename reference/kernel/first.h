// Finds the object that a ray hits first, without a wrong decision.
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "reference/kernel/cylinder.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "reference/stages/first_hit.h"

namespace reference::kernel {

/// The lists are those that for_each_kind visits.
struct Objects {
    std::vector<Sphere<double>> spheres = {};
    std::vector<Triangle<double>> triangles = {};
    std::vector<Cylinder<double>> cylinders = {};
};

/// The object hit at the smallest t >= 0.
struct First {
    std::optional<FirstObject> object;  ///< empty if the ray or one of the objects is invalid
    std::size_t index = 0;              ///< among the objects of its kind; 0 if none is first
};

/// The ray's result for each of the Objects, in lists of the same names.
struct Cast {
    std::vector<SphereHit> spheres;
    std::vector<TriangleHit> triangles;
    std::vector<CylinderHit> cylinders;
    First first;
};

/// Intersects the ray with every object and finds the first hit. Overwrites `result`, whose memory is reused from ray
/// to ray.
void cast_ray(const Ray<double>& ray, const Objects& objects, Cast& result);

/// The first hit of one sphere and one triangle. t has a relative error of at most 2^-26; it is 0 for none and invalid.
struct FirstHit {
    enum class Kind {
        sphere,
        triangle,
        tie,      ///< both are hit at exactly the same t
        none,     ///< nothing is hit
        invalid,  ///< the ray or one of the objects is invalid
    };
    Kind kind;
    double t;
};
using Object = std::variant<Sphere<double>, Triangle<double>, Cylinder<double>>;
/// The sign of (the t of `one`) - (the t of `other`), where both are hit. Exact, but slow.
std::partial_ordering order_exactly(const Ray<double>& ray, const Object& object, const Object& other);

/// Each t is known to a relative error of 2^-26, so a difference above 2^-24 of the smaller t decides the order (proven
/// in first.g).
KERNEL_INLINE FirstHit first_of(const Ray<double>& ray, const Sphere<double>& sphere,
                                const Triangle<double>& triangle) {
    const auto at_sphere = intersect_to_float(ray, sphere);
    const auto at_triangle = intersect_to_float(ray, triangle);
    if (at_sphere.result == SphereResult::invalid || at_triangle.result == TriangleResult::invalid) {
        return {FirstHit::Kind::invalid, 0};
    }
    const bool sphere_is_hit = at_sphere.result != SphereResult::miss;
    const bool triangle_is_hit = at_triangle.result == TriangleResult::hit;
    const double slack = 0x1p-24 * std::min(at_sphere.t, at_triangle.t) + 0x1p-1000;
    const double difference = at_sphere.t - at_triangle.t;
    bool sphere_is_nearer = difference < 0;
    if (sphere_is_hit & triangle_is_hit & !(std::abs(difference) > slack)) [[unlikely]] {
        const auto order = order_exactly(ray, sphere, triangle);
        if (order == 0) return {FirstHit::Kind::tie, at_sphere.t};
        sphere_is_nearer = order < 0;
    }
    // Selected by index, because a branch here would be unpredictable.
    const bool sphere_is_first = sphere_is_hit & (!triangle_is_hit | sphere_is_nearer);
    const std::array kinds{FirstHit::Kind::none, FirstHit::Kind::triangle, FirstHit::Kind::sphere,
                           FirstHit::Kind::sphere};
    const std::array ts{at_triangle.t, at_sphere.t};
    return {kinds[std::size_t{2} * sphere_is_first + triangle_is_hit], ts[sphere_is_first]};
}

}  // namespace reference::kernel
