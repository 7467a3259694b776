// The ladder of ray and cylinder: the tube is a circle seen from above, and the caps are planes. All follow one policy:
// t >= 0 is a hit, a tangent touches, and the rim belongs to the tube.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/accuracy/methods/sphere_methods.h"

namespace reference::accuracy {

template <class S>
HalvedQuadratic<S> halved_quadratic(const Ray<S>& ray, const Cylinder<S>& cylinder) {
    const S x = ray.origin.x - cylinder.center.x, z = ray.origin.z - cylinder.center.z;
    const Vec3<S>& d = ray.direction;
    return {d.x * d.x + d.z * d.z, x * d.x + z * d.z, x * x + z * z - cylinder.radius * cylinder.radius};
}

/// The handout of 2024: the smallest t of the tube's roots between the caps and of the caps inside the tube.
template <class S>
Hit<S> nearest_part(const Ray<S>& ray, const Cylinder<S>& cylinder, const std::array<S, 2>& roots) {
    const Vec3<S> from = ray.origin - cylinder.center;
    const S half = cylinder.height / S(2);
    Hit<S> first;
    const auto meet = [&](const S& t, bool is_met) {
        if (is_met && t >= 0 && (!first.hit || t < first.t)) first = {true, t};
    };
    for (const S& t : roots) meet(t, std::abs(from.y + t * ray.direction.y) <= half);
    for (const S& level : {half, -half}) {
        const S t = (level - from.y) / ray.direction.y;
        const S x = from.x + t * ray.direction.x, z = from.z + t * ray.direction.z;
        meet(t, x * x + z * z < cylinder.radius * cylinder.radius);
    }
    return first;
}

/// With the roots of every textbook; those of a ray parallel to the axis, and of one that passes the tube, are NaN.
template <class S>
Hit<S> textbook_parts(const Ray<S>& ray, const Cylinder<S>& cylinder) {
    const auto [a, half_b, c] = halved_quadratic(ray, cylinder);
    const S b = S(2) * half_b;
    const S root = std::sqrt(b * b - S(4) * a * c);
    return nearest_part<S>(ray, cylinder, {(-b - root) / (S(2) * a), (-b + root) / (S(2) * a)});
}

/// With the roots that subtract no nearly equal numbers, as in roots_by_q.
template <class S>
Hit<S> stable_parts(const Ray<S>& ray, const Cylinder<S>& cylinder) {
    const HalvedQuadratic<S> quadratic = halved_quadratic(ray, cylinder);
    const S q = -quadratic.b - std::copysign(std::sqrt(quadratic.discriminant()), quadratic.b);
    return nearest_part<S>(ray, cylinder, {q / quadratic.a, quadratic.c / q});
}

/// Kay and Kajiya, "Ray Tracing Complex Scenes" (1986): the ray is inside where it is in the tube and between the caps,
/// without a branch. A ray parallel to the axis is in the tube everywhere or nowhere.
template <class S>
Hit<S> slabs(const Ray<S>& ray, const Cylinder<S>& cylinder) {
    const HalvedQuadratic<S> q = halved_quadratic(ray, cylinder);
    const S D = q.discriminant();
    const S root = std::sqrt(std::abs(D));
    const S start = ray.origin.y - cylinder.center.y;
    const S half = cylinder.height / S(2);
    const S top = (half - start) / ray.direction.y, bottom = (-half - start) / ray.direction.y;
    // The second argument is ignored where it is NaN.
    const S enter = std::max(std::min(top, bottom), (-q.b - root) / q.a);
    const S leave = std::min(std::max(top, bottom), (root - q.b) / q.a);
    const int meets_tube = static_cast<int>(D >= 0) & (static_cast<int>(q.a > 0) | static_cast<int>(q.c < 0));
    const int is_hit = meets_tube & static_cast<int>(enter <= leave) & static_cast<int>(leave >= 0);
    return {is_hit != 0, enter >= 0 ? enter : leave};
}

}  // namespace reference::accuracy
