// The ladder of ray and sphere: |f + t d|² = R² with f = origin - center, that is a t² + 2 b t + c = 0. All methods
// follow one policy: t >= 0 is a hit, a tangent touches.
#pragma once

#include <cmath>

#include "reference/accuracy/rays/hit.h"

namespace reference::accuracy {

/// a t² + 2 b t + c.
template <class S>
struct HalvedQuadratic {
    S a;
    S b;
    S c;
    S discriminant() const { return b * b - a * c; }
};

template <class S>
HalvedQuadratic<S> halved_quadratic(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    return {dot(ray.direction, ray.direction), dot(f, ray.direction), dot(f, f) - sphere.radius * sphere.radius};
}

/// Every textbook: t = (-b ∓ √(b² - 4ac)) / 2a.
template <class S>
Hit<S> naive_quadratic(const Ray<S>& ray, const Sphere<S>& sphere) {
    const auto [a, half_b, c] = halved_quadratic(ray, sphere);
    const S b = S(2) * half_b;
    const S D = b * b - S(4) * a * c;
    if (!(D >= 0)) return {};
    const S root = std::sqrt(D);
    return first_root(S((-b - root) / (S(2) * a)), S((-b + root) / (S(2) * a)));
}

/// Shirley, Black and Hollasch, "Ray Tracing in One Weekend", 6.2: b halved.
template <class S>
Hit<S> half_b(const Ray<S>& ray, const Sphere<S>& sphere) {
    const HalvedQuadratic<S> q = halved_quadratic(ray, sphere);
    const S D = q.discriminant();
    if (!(D >= 0)) return {};
    const S root = std::sqrt(D);
    return first_root(S((-q.b - root) / q.a), S((-q.b + root) / q.a));
}

/// Without a branch, so the processor has nothing to predict. |D| avoids the check of the root's argument; a negative D
/// is still a miss.
template <class S>
Hit<S> half_b_branch_free(const Ray<S>& ray, const Sphere<S>& sphere) {
    const HalvedQuadratic<S> q = halved_quadratic(ray, sphere);
    const S D = q.discriminant();
    const S root = std::sqrt(std::abs(D));
    const S near = -q.b - root;
    const S far = root - q.b;
    const S first = near >= 0 ? near : far;
    return {(static_cast<int>(D >= 0) & static_cast<int>(first >= 0)) != 0, first / q.a};
}

/// The roots without subtracting nearly equal numbers: q = -b - sign(b) √D, then q/a and c/q. Press et al., "Numerical
/// Recipes", 5.6. D is b² - ac, computed by any formula.
template <class S>
Hit<S> roots_by_q(const HalvedQuadratic<S>& quadratic, const S& D) {
    if (!(D >= 0)) return {};
    const S root = std::sqrt(D);
    const S q = quadratic.b > 0 ? -quadratic.b - root : -quadratic.b + root;
    const S s = q / quadratic.a;
    const S other = q == 0 ? S(0) : quadratic.c / q;  // q = 0 where both roots are 0
    return s < other ? first_root(s, other) : first_root(other, s);
}

template <class S>
Hit<S> stable(const Ray<S>& ray, const Sphere<S>& sphere) {
    const HalvedQuadratic<S> q = halved_quadratic(ray, sphere);
    return roots_by_q(q, q.discriminant());
}

/// Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// chapter 7: the discriminant from the distance of the center to the ray.
template <class S>
Hit<S> haines(const Ray<S>& ray, const Sphere<S>& sphere) {
    const HalvedQuadratic<S> q = halved_quadratic(ray, sphere);
    const Vec3<S> nearest = ray.origin - sphere.center - scaled(ray.direction, S(q.b / q.a));
    return roots_by_q(q, S(q.a * (sphere.radius * sphere.radius - dot(nearest, nearest))));
}

}  // namespace reference::accuracy
