// The inputs and results of the certified kernel. Inputs are doubles and count as exact. All bounds are closed: t >= 0
// is a hit, edges and vertices belong to the triangle, a tangent ray touches the sphere.
#pragma once

#include <cmath>

#include "reference/stages/scene.h"

/// A filter is a few dozen operations without a branch. Calling it would cost as much as running it.
#define KERNEL_INLINE inline __attribute__((always_inline))

namespace reference::kernel {

/// The points origin + t direction with t >= 0. The direction need not have unit length.
template <class T>
struct Ray {
    Vec3<T> origin;
    Vec3<T> direction;
};

enum class SphereResult {
    hit,
    miss,
    tangent,  ///< the discriminant is exactly 0, and t >= 0
    invalid,  ///< a number is not finite, the direction is zero, or the radius is not above 0
};

enum class TriangleResult {
    hit,
    miss,
    coplanar,    ///< the ray lies in the triangle's plane, whether it meets the triangle or not
    degenerate,  ///< the triangle has no area
    invalid,     ///< a number is not finite, or the direction is zero
};

constexpr bool is_hit(SphereResult result) {
    return result == SphereResult::hit || result == SphereResult::tangent;
}
constexpr bool is_hit(TriangleResult result) {
    return result == TriangleResult::hit;
}

/// t is within one unit in the last place of the true value, and exactly +0 if the true value is 0 (never -0). It is
/// infinite if the true value exceeds the range of doubles, and 0 without a hit.
struct SphereHit {
    SphereResult result;
    double t;
};

/// t, u and v follow the rules of SphereHit::t.
struct TriangleHit {
    TriangleResult result;
    double t;
    double u;
    double v;
};

/// A decision, with t to a relative error of 2^-26 (a quarter of a float's last place), or to one unit in the last
/// place if t is subnormal. Without a hit t is 0.
template <class Result>
struct FloatHit {
    Result result;
    double t;
};

inline bool is_finite(const Vec3<double>& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

inline bool is_valid(const Ray<double>& ray) {
    const Vec3<double>& d = ray.direction;
    return is_finite(ray.origin) && is_finite(d) && (d.x != 0 || d.y != 0 || d.z != 0);
}

/// The same over a scalar type that can be made from a double.
template <class S>
Vec3<S> over(const Vec3<double>& p) {
    return Vec3<S>(S(p.x), S(p.y), S(p.z));
}
template <class S>
Ray<S> over(const Ray<double>& ray) {
    return {over<S>(ray.origin), over<S>(ray.direction)};
}
template <class S>
Sphere<S> over(const Sphere<double>& sphere) {
    return {over<S>(sphere.center), S(sphere.radius)};
}
template <class S>
Triangle<S> over(const Triangle<double>& triangle) {
    return {over<S>(triangle.A), over<S>(triangle.B), over<S>(triangle.C)};
}
template <class S>
Cylinder<S> over(const Cylinder<double>& cylinder) {
    return {over<S>(cylinder.center), S(cylinder.radius), S(cylinder.height)};
}

}  // namespace reference::kernel
