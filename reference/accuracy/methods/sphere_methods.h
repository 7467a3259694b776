// The ladder of ray and sphere: |f + t d|² = R² with f = origin - center, by every formula that is taught or shipped.
// All follow one policy: t >= 0 is a hit, a tangent touches.
#pragma once

#ifndef GLM_ENABLE_EXPERIMENTAL
#define GLM_ENABLE_EXPERIMENTAL
#endif
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtx/intersect.hpp>
#include <utility>

#include "reference/accuracy/methods/fused.h"
#include "reference/accuracy/rays/hit.h"
#include "reference/kernel/sphere.h"
#include "reference/numbers/interval.h"

namespace reference::accuracy {

/// Every textbook: t = (-b ∓ √(b² - 4ac)) / 2a.
template <class S>
Hit<S> naive_quadratic(const Ray<S>& ray, const Sphere<S>& sphere) {
    using std::sqrt;
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = S(2) * dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const S D = b * b - S(4) * a * c;
    if (!at_least_zero(D)) return {};
    const S root = sqrt(D);
    return first_root(S((-b - root) / (S(2) * a)), S((-b + root) / (S(2) * a)));
}

/// Shirley, Black and Hollasch, "Ray Tracing in One Weekend", 6.2: b halved.
template <class S>
Hit<S> half_b(const Ray<S>& ray, const Sphere<S>& sphere) {
    using std::sqrt;
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const S D = b * b - a * c;
    if (!at_least_zero(D)) return {};
    const S root = sqrt(D);
    return first_root(S((-b - root) / a), S((-b + root) / a));
}

/// half_b() without a branch, so the processor has nothing to predict. |D| spares the check of a root's argument; a
/// negative D is a miss all the same.
template <class S>
Hit<S> half_b_branch_free(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const S D = b * b - a * c;
    const S root = std::sqrt(std::abs(D));
    const S near = -b - root;
    const S far = root - b;
    const S first = near >= 0 ? near : far;
    return {(static_cast<int>(D >= 0) & static_cast<int>(first >= 0)) != 0, first / a};
}

/// The decision alone needs no root: the line meets the sphere, and the origin is inside or the sphere ahead.
template <class S>
bool half_b_decision(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    return (static_cast<int>(b * b - a * c >= 0) & (static_cast<int>(c <= 0) | static_cast<int>(b <= 0))) != 0;
}

/// half_b_branch_free() with every product that is added to something fused with the sum.
template <class S>
Hit<S> half_b_fused(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = fused_dot(ray.direction, ray.direction);
    const S b = fused_dot(f, ray.direction);
    const S c = std::fma(-sphere.radius, sphere.radius, fused_dot(f, f));
    const S D = std::fma(b, b, -(a * c));
    const S root = std::sqrt(std::abs(D));
    const S near = -b - root;
    const S far = root - b;
    const S first = near >= 0 ? near : far;
    return {(static_cast<int>(D >= 0) & static_cast<int>(first >= 0)) != 0, first / a};
}

/// Programs that distrust rounding take what is nearly a hit for a hit.
template <class S>
Hit<S> half_b_with_epsilon(const Ray<S>& ray, const Sphere<S>& sphere) {
    constexpr S epsilon = S(1e-9);
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const S D = b * b - a * c;
    const S root = std::sqrt(std::abs(D));
    const S near = -b - root;
    const S far = root - b;
    const S least = -epsilon * a;
    const S first = near >= least ? near : far;
    return {(static_cast<int>(D >= -epsilon) & static_cast<int>(first >= least)) != 0, first / a};
}

/// The roots of a t² + 2bt + c without subtracting nearly equal numbers: q = -b - sign(b) √D, then q/a and c/q. Press
/// et al., "Numerical Recipes", 5.6. D is b² - ac, computed by any formula.
template <class S>
Hit<S> roots_by_q(const S& a, const S& b, const S& c, const S& D) {
    using std::sqrt;
    if (!(D >= 0)) return {};
    const S root = sqrt(D);
    const S q = b > 0 ? -b - root : -b + root;
    const S one = q / a;
    const S other = q == 0 ? S(0) : c / q;  // q = 0 where both roots are 0
    return one < other ? first_root(one, other) : first_root(other, one);
}

template <class S>
Hit<S> stable(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    return roots_by_q(a, b, c, S(b * b - a * c));
}

/// stable() without a branch and with one division: from outside t = c/q, from inside ahead q/a, both by |q|. A ray
/// that starts where it touches gives 0/0, which is a miss.
template <class S>
Hit<S> stable_branch_free(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const S D = b * b - a * c;
    const S q = std::abs(b) + std::sqrt(std::abs(D));
    const bool leaves = static_cast<bool>(static_cast<int>(c < 0) & static_cast<int>(b < 0));
    const S t = (leaves ? q : std::abs(c)) / (leaves ? a : q);
    return {(static_cast<int>(D >= 0) & (static_cast<int>(c <= 0) | static_cast<int>(b <= 0))) != 0, t};
}

/// Kahan's b² - ac with two fused operations, off by 1.5 ulp at most (Jeannerod, Louvet and Muller, "Further analysis
/// of Kahan's algorithm for the accurate computation of 2 x 2 determinants", 2013).
template <class S>
Hit<S> kahan(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const S product = a * c;
    const S rest = std::fma(-a, c, product);
    return roots_by_q(a, b, c, S(std::fma(b, b, -product) + rest));
}

/// Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// chapter 7: the discriminant from the distance of the centre to the ray.
template <class S>
Hit<S> haines(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const Vec3<S> nearest = f - scaled(ray.direction, S(b / a));
    return roots_by_q(a, b, c, S(a * (sphere.radius * sphere.radius - dot(nearest, nearest))));
}

/// b² - ac = aR² - |f × d|², by Lagrange's identity |f|²|d|² = (f·d)² + |f × d|².
template <class S>
Hit<S> lagrange(const Ray<S>& ray, const Sphere<S>& sphere) {
    const Vec3<S> f = ray.origin - sphere.center;
    const S a = dot(ray.direction, ray.direction);
    const S b = dot(f, ray.direction);
    const S c = dot(f, f) - sphere.radius * sphere.radius;
    const Vec3<S> moment = cross(f, ray.direction);
    return roots_by_q(a, b, c, S(a * sphere.radius * sphere.radius - dot(moment, moment)));
}

/// GLM's function, which requires a unit direction and finds no hit nearer than epsilon.
template <class S>
Hit<S> glm_sphere(const Ray<S>& ray, const Sphere<S>& sphere) {
    const S speed = glm::length(ray.direction);
    S distance = 0;
    const bool hit = glm::intersectRaySphere(ray.origin, Vec3<S>(ray.direction / speed), sphere.center,
                                             sphere.radius * sphere.radius, distance);
    return {hit, distance / speed};
}

/// Pharr, Jakob and Humphreys, "Physically Based Rendering" (4th ed.), 6.2.2: the quadratic in intervals; a hit that
/// they cannot prove is a miss. t is the middle of its interval.
inline Hit<float> conservative_quadratic(const Ray<float>& ray, const Sphere<float>& sphere) {
    using I = Interval<float>;
    const auto exact = [](const Vec3<float>& p) { return Vec3<I>(I(p.x), I(p.y), I(p.z)); };
    const Vec3<I> d = exact(ray.direction);
    const Vec3<I> f = exact(ray.origin) - exact(sphere.center);
    const I R(sphere.radius);
    const I a = dot(d, d);
    const I b = dot(f, d);
    const I c = dot(f, f) - R * R;
    const Vec3<I> nearest = f - scaled(d, I(b / a));
    const I distance = length(nearest);
    const I D = a * (R + distance) * (R - distance);
    if (!(D.lo() >= 0)) return {};
    const I root = sqrt(D);
    const I q = b.lo() + b.hi() > 0 ? -b - root : -b + root;
    I near = q / a;
    I far = c / q;
    if (near.lo() > far.lo()) std::swap(near, far);
    const I& first = near.lo() >= 0 ? near : far;
    return {first.lo() >= 0, (first.lo() + first.hi()) / 2};
}

/// A filtered predicate as libraries of exact geometry have it: intervals of double first, and whole numbers where they
/// leave a sign open. Brönnimann, Burnikel and Pion, "Interval arithmetic yields efficient dynamic filters for
/// computational geometry" (2001).
inline bool interval_filtered(const Ray<double>& ray, const Sphere<double>& sphere) {
    using I = Interval<double>;
    const auto exact = [](const Vec3<double>& p) { return Vec3<I>(I(p.x), I(p.y), I(p.z)); };
    const Vec3<I> d = exact(ray.direction);
    const Vec3<I> f = exact(ray.origin) - exact(sphere.center);
    const I a = dot(d, d);
    const I b = dot(f, d);
    const I c = dot(f, f) - I(sphere.radius) * I(sphere.radius);
    if (c.hi() < 0) return true;
    if (c.lo() > 0) {
        if (b.lo() > 0) return false;
        const auto D = sign_of(b * b - a * c);
        if (D < 0) return false;
        if (D > 0 && b.hi() < 0) return true;
    }
    const auto result = kernel::decide_exactly(ray, sphere);
    return result == kernel::SphereResult::hit || result == kernel::SphereResult::tangent;
}

}  // namespace reference::accuracy
