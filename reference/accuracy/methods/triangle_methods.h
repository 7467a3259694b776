// The ladder of ray and triangle: A + u(B-A) + v(C-A) = origin + t d. All follow one policy: t >= 0 is a hit, edges and
// vertices belong to the triangle, a ray parallel to the plane or in it misses.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "reference/accuracy/rays/hit.h"

namespace reference::accuracy {

/// Without a branch. False if any of them is NaN.
template <class S>
bool is_inside(const S& t, const S& u, const S& v) {
    return (static_cast<int>(t >= 0) & static_cast<int>(u >= 0) & static_cast<int>(v >= 0) &
            static_cast<int>(u + v <= 1)) != 0;
}

/// The handout's linear system, solved by GLM's inverse matrix. The inverse of a singular matrix has no finite entry.
template <class S>
Hit<S> by_inverse(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Mat3<S> M(-ray.direction, triangle.B - triangle.A, triangle.C - triangle.A);
    const Vec3<S> x = glm::inverse(M) * Vec3<S>(ray.origin - triangle.A);
    return {is_inside(x.x, x.y, x.z), x.x};
}

/// Cramer's rule: Shirley and Marschner, "Fundamentals of Computer Graphics", 4.4.2.
template <class S>
Hit<S> cramer(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> normal = cross(p, q);
    const Vec3<S> moment = cross(s, ray.direction);
    const S det = -dot(ray.direction, normal);
    if (det == 0) return {};
    const S t = dot(s, normal) / det;
    if (!(t >= 0)) return {};
    const S u = dot(moment, q) / det;
    if (!(u >= 0 && u <= 1)) return {};
    const S v = -dot(moment, p) / det;
    return {v >= 0 && u + v <= 1, t};
}

/// cramer() without a branch: the numerators are compared before the one division, with their signs turned so that det
/// is positive.
template <class S>
Hit<S> cramer_branch_free(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> normal = cross(p, q);
    const Vec3<S> moment = cross(s, ray.direction);
    const S minus_det = dot(ray.direction, normal);
    const S towards = minus_det < 0 ? S(-1) : S(1);
    const S det = std::abs(minus_det);
    const S minus_u = towards * dot(moment, q);
    const S v = towards * dot(moment, p);
    const S t = -(towards * dot(s, normal));
    const int inside = static_cast<int>(minus_u <= 0) & static_cast<int>(v >= 0) &
                       static_cast<int>(v - minus_u <= det) & static_cast<int>(t >= 0) & static_cast<int>(det > 0);
    return {inside != 0, t / det};
}

/// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997), with its early exits; det is compared
/// with 0, as no epsilon suits triangles of every size.
template <class S>
Hit<S> moller_trumbore(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> d_q = cross(ray.direction, q);
    const S det = dot(p, d_q);
    if (det == 0) return {};
    const S inverse = S(1) / det;
    const Vec3<S> s = ray.origin - triangle.A;
    const S u = dot(s, d_q) * inverse;
    if (!(u >= 0 && u <= 1)) return {};
    const Vec3<S> s_p = cross(s, p);
    const S v = dot(ray.direction, s_p) * inverse;
    if (!(v >= 0 && u + v <= 1)) return {};
    const S t = dot(q, s_p) * inverse;
    return {t >= 0, t};
}

/// Möller and Trumbore without a branch: there is no early exit, so the processor has nothing to predict. det = 0
/// leaves no finite u, v and t.
template <class S>
Hit<S> moller_trumbore_branch_free(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> d_q = cross(ray.direction, q);
    const Vec3<S> s_p = cross(s, p);
    const S inverse = S(1) / dot(p, d_q);
    const S u = dot(s, d_q) * inverse;
    const S v = dot(ray.direction, s_p) * inverse;
    const S t = dot(q, s_p) * inverse;
    return {is_inside(t, u, v), t};
}

}  // namespace reference::accuracy
