// The ladder of ray and triangle: A + u(B-A) + v(C-A) = origin + t d. All follow one policy: t >= 0 is a hit, edges and
// vertices belong to the triangle, a ray parallel to the plane or in it misses. A method that prepares the triangle is
// timed with and without that.
#pragma once

#ifndef GLM_ENABLE_EXPERIMENTAL
#define GLM_ENABLE_EXPERIMENTAL
#endif
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtx/intersect.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <type_traits>
#include <utility>

#include "reference/accuracy/methods/fused.h"
#include "reference/accuracy/rays/hit.h"
#include "reference/kernel/pair.h"

namespace reference::accuracy {

/// False if any of them is NaN.
template <class S>
bool is_inside(const S& t, const S& u, const S& v) {
    return t >= 0 && u >= 0 && v >= 0 && u + v <= 1;
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

/// What Cramer's rule needs of the triangle alone.
template <class S>
struct CramerTriangle {
    Vec3<S> A;
    Vec3<S> p;  ///< B - A
    Vec3<S> q;  ///< C - A
    Vec3<S> normal;

    explicit CramerTriangle(const Triangle<S>& triangle)
        : A(triangle.A), p(triangle.B - triangle.A), q(triangle.C - triangle.A), normal(cross(p, q)) {}
};

/// cramer() without a branch: the numerators are compared before the one division, with their signs turned so that det
/// is positive.
template <class S>
Hit<S> cramer_branch_free(const Ray<S>& ray, const CramerTriangle<S>& triangle) {
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> moment = cross(s, ray.direction);
    const S minus_det = dot(ray.direction, triangle.normal);
    const S towards = minus_det < 0 ? S(-1) : S(1);
    const S det = std::abs(minus_det);
    const S minus_u = towards * dot(moment, triangle.q);
    const S v = towards * dot(moment, triangle.p);
    const S t = -(towards * dot(s, triangle.normal));
    const int inside = static_cast<int>(minus_u <= 0) & static_cast<int>(v >= 0) &
                       static_cast<int>(v - minus_u <= det) & static_cast<int>(t >= 0) & static_cast<int>(det > 0);
    return {inside != 0, t / det};
}
template <class S>
bool cramer_decision(const Ray<S>& ray, const CramerTriangle<S>& triangle) {
    return cramer_branch_free(ray, triangle).hit;
}

/// Cramer's rule without a branch as this project's kernel computes it, two numbers in one register, but without
/// bounds.
template <class S>
Hit<double> cramer_in_pairs(const Ray<S>& ray, const Triangle<S>& triangle) {
    using kernel::Pair;
    using kernel::PairVec3;
    const PairVec3 p_s = PairVec3(triangle.B, ray.origin) - PairVec3(triangle.A, triangle.A);
    const PairVec3 q_d = PairVec3(triangle.C, ray.direction) - PairVec3(triangle.A, Vec3<S>(0, 0, 0));
    const PairVec3 side_normal = swapped(cross(p_s, q_d));
    const Pair signed_det = dot(q_d, side_normal);
    const auto towards = kernel::sign_of_second(signed_det);
    const Pair v_minus_t = kernel::turned(dot(p_s, side_normal), towards);
    const Pair minus_u_det = kernel::turned(signed_det, towards);
    const Pair w = minus_u_det + kernel::swapped(minus_u_det) - v_minus_t;
    const double least = kernel::lesser(kernel::lesser(-minus_u_det, v_minus_t), w)[0];
    const int hit =
        static_cast<int>(least >= 0) & static_cast<int>(v_minus_t[1] <= 0) & static_cast<int>(minus_u_det[1] > 0);
    return {hit != 0, -v_minus_t[1] / minus_u_det[1]};
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
/// leaves no finite u, v and t. Programs that distrust rounding take what is nearly a hit, by epsilon, for a hit.
template <class S>
Hit<S> moller_trumbore_branch_free(const Ray<S>& ray, const Triangle<S>& triangle, S epsilon = 0) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> d_q = cross(ray.direction, q);
    const Vec3<S> s_p = cross(s, p);
    const S inverse = S(1) / dot(p, d_q);
    const S u = dot(s, d_q) * inverse;
    const S v = dot(ray.direction, s_p) * inverse;
    const S t = dot(q, s_p) * inverse;
    const int inside = static_cast<int>(t >= -epsilon) & static_cast<int>(u >= -epsilon) &
                       static_cast<int>(v >= -epsilon) & static_cast<int>(u + v <= 1 + epsilon);
    return {inside != 0, t};
}

/// The decision alone: the numerators are compared without a division.
template <class S>
bool moller_trumbore_decision(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> d_q = cross(ray.direction, q);
    const Vec3<S> s_p = cross(s, p);
    const S signed_det = dot(p, d_q);
    const S towards = std::copysign(S(1), signed_det);
    const S det = std::abs(signed_det);
    const S u = towards * dot(s, d_q);
    const S v = towards * dot(ray.direction, s_p);
    const S t = towards * dot(q, s_p);
    const S least = std::min(std::min(u, v), std::min(det - u - v, t));
    return (static_cast<int>(least >= 0) & static_cast<int>(det > 0)) != 0;
}

/// moller_trumbore_branch_free() with every product that is added to something fused with the sum.
template <class S>
Hit<S> moller_trumbore_fused(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> p = triangle.B - triangle.A;
    const Vec3<S> q = triangle.C - triangle.A;
    const Vec3<S> s = ray.origin - triangle.A;
    const Vec3<S> d_q = fused_cross(ray.direction, q);
    const Vec3<S> s_p = fused_cross(s, p);
    const S inverse = S(1) / fused_dot(p, d_q);
    const S u = fused_dot(s, d_q) * inverse;
    const S v = fused_dot(ray.direction, s_p) * inverse;
    const S t = fused_dot(q, s_p) * inverse;
    const int inside =
        static_cast<int>(t >= 0) & static_cast<int>(u >= 0) & static_cast<int>(v >= 0) & static_cast<int>(u + v <= 1);
    return {inside != 0, t};
}

/// Havel and Herout, "Yet Faster Ray-Triangle Intersection (Using SSE4)" (2010): the triangle's plane, and two planes
/// that measure u and v.
template <class S>
struct HavelHeroutTriangle {
    Vec3<S> normal;
    Vec3<S> to_u;
    Vec3<S> to_v;
    S height;  ///< normal . A
    S u_at_origin;
    S v_at_origin;

    explicit HavelHeroutTriangle(const Triangle<S>& triangle) {
        const Vec3<S> p = triangle.B - triangle.A;
        const Vec3<S> q = triangle.C - triangle.A;
        normal = cross(p, q);
        const S inverse = S(1) / dot(normal, normal);
        to_u = scaled(cross(q, normal), inverse);
        to_v = scaled(cross(normal, p), inverse);
        height = dot(normal, triangle.A);
        u_at_origin = -dot(to_u, triangle.A);
        v_at_origin = -dot(to_v, triangle.A);
    }
};

template <class S>
Hit<S> havel_herout(const Ray<S>& ray, const HavelHeroutTriangle<S>& triangle) {
    const S signed_det = dot(triangle.normal, ray.direction);
    const S towards = std::copysign(S(1), signed_det);
    const S det = std::abs(signed_det);
    const S t = towards * (triangle.height - dot(triangle.normal, ray.origin));
    const Vec3<S> point = scaled(ray.origin, det) + scaled(ray.direction, t);
    const S u = dot(point, triangle.to_u) + det * triangle.u_at_origin;
    const S v = dot(point, triangle.to_v) + det * triangle.v_at_origin;
    const S least = std::min(std::min(u, v), std::min(det - u - v, t));
    return {(static_cast<int>(least >= 0) & static_cast<int>(det > 0)) != 0, t / det};
}

/// The edges in Plücker coordinates: the side of an edge that a line passes on is the sign of one product. Teller and
/// Hohmeyer, "Determining the Lines Through Four Lines" (1999). t is that of the plane.
template <class S>
struct PluckerTriangle {
    std::array<Vec3<S>, 3> along;
    std::array<Vec3<S>, 3> moment;
    Vec3<S> normal;
    S height;

    explicit PluckerTriangle(const Triangle<S>& triangle)
        : along{Vec3<S>(triangle.B - triangle.A), Vec3<S>(triangle.C - triangle.B), Vec3<S>(triangle.A - triangle.C)},
          moment{cross(triangle.A, triangle.B), cross(triangle.B, triangle.C), cross(triangle.C, triangle.A)},
          normal(cross(along[0], along[1])),
          height(dot(normal, triangle.A)) {}
};

template <class S>
Hit<S> plucker(const Ray<S>& ray, const PluckerTriangle<S>& triangle) {
    const Vec3<S> moment = cross(ray.origin, ray.direction);
    const auto side = [&](std::size_t edge) {
        return dot(ray.direction, triangle.moment[edge]) + dot(moment, triangle.along[edge]);
    };
    const S det = dot(triangle.normal, ray.direction);
    const S towards = std::copysign(S(1), det);
    const S t = (triangle.height - dot(triangle.normal, ray.origin)) / det;
    const S least = std::min(std::min(towards * side(0), towards * side(1)), towards * side(2));
    const int inside = static_cast<int>(least >= 0) & static_cast<int>(t >= 0) & static_cast<int>(std::abs(det) > 0);
    return {inside != 0, t};
}

/// p rotated cyclically so that coordinate k comes first.
template <class S>
Vec3<S> turned(const Vec3<S>& p, int k) {
    return {p[k], p[(k + 1) % 3], p[(k + 2) % 3]};
}

/// Baldwin and Weber, "Fast Ray-Triangle Intersections by Coordinate Transformation" (2016): the affine map that takes
/// the triangle to (0, 0), (1, 0), (0, 1), divided by the largest component of the normal.
template <class S>
Hit<S> baldwin_weber(const Ray<S>& ray, const Triangle<S>& triangle) {
    const Vec3<S> normal = cross(Vec3<S>(triangle.B - triangle.A), Vec3<S>(triangle.C - triangle.A));
    const Vec3<S> sizes = glm::abs(normal);
    const int k = sizes.x > sizes.y && sizes.x > sizes.z ? 0 : (sizes.y > sizes.z ? 1 : 2);
    const Vec3<S> A = turned(triangle.A, k);
    const Vec3<S> B = turned(triangle.B, k);
    const Vec3<S> C = turned(triangle.C, k);
    const Vec3<S> n = turned(normal, k);
    const Vec3<S> p = B - A;
    const Vec3<S> q = C - A;
    const Vec3<S> origin = turned(ray.origin, k);
    const Vec3<S> d = turned(ray.direction, k);
    const S height = origin.x + n.y / n.x * origin.y + n.z / n.x * origin.z - dot(A, n) / n.x;
    const S approach = d.x + n.y / n.x * d.y + n.z / n.x * d.z;
    if (!(approach != 0)) return {};
    const S t = -height / approach;
    const S y = origin.y + t * d.y;
    const S z = origin.z + t * d.z;
    const S u = q.z / n.x * y - q.y / n.x * z + (C.y * A.z - C.z * A.y) / n.x;
    const S v = p.y / n.x * z - p.z / n.x * y - (B.y * A.z - B.z * A.y) / n.x;
    return {is_inside(t, u, v), t};
}

/// The bound of 6.8.7 of "Physically Based Rendering" for the t of a sheared triangle. The heights x come first. n
/// roundings in a row are off by gamma(n) of the result at most.
template <class S>
S error_of_sheared_t(const Vec3<S>& A, const Vec3<S>& B, const Vec3<S>& C, const Vec3<S>& UVW, const S& det) {
    constexpr S u = std::numeric_limits<S>::epsilon() / 2;
    const auto gamma = [](int n) { return S(n) * u / (1 - S(n) * u); };
    const auto largest = [](const S& p, const S& q, const S& r) {
        return std::max(std::max(std::abs(p), std::abs(q)), std::abs(r));
    };
    const S height = largest(A.x, B.x, C.x);
    const S y = largest(A.y, B.y, C.y);
    const S z = largest(A.z, B.z, C.z);
    const S edge = largest(UVW.x, UVW.y, UVW.z);
    const S of_height = gamma(3) * height;
    const S of_y = gamma(5) * (y + height);
    const S of_z = gamma(5) * (z + height);
    const S of_edge = 2 * (gamma(2) * y * z + of_z * y + of_y * z);
    return 3 * (gamma(3) * edge * height + of_edge * height + of_height * edge) / std::abs(det);
}

/// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (2013): the triangle sheared into the ray's own
/// coordinates; an edge function of exactly 0 is computed again in the wider type.
template <class S, bool with_bound>
Hit<S> sheared_triangle(const Ray<S>& ray, const Triangle<S>& triangle) {
    using Wider = std::conditional_t<std::is_same_v<S, float>, double, long double>;
    const Vec3<S> sizes = glm::abs(ray.direction);
    const int k = sizes.x > sizes.y && sizes.x > sizes.z ? 0 : (sizes.y > sizes.z ? 1 : 2);
    const Vec3<S> d = turned(ray.direction, k);
    const Vec3<S> shear(S(1) / d.x, d.y / d.x, d.z / d.x);
    const auto sheared = [&](const Vec3<S>& corner) {
        const Vec3<S> p = turned(Vec3<S>(corner - ray.origin), k);
        return Vec3<S>(shear.x * p.x, p.y - shear.y * p.x, p.z - shear.z * p.x);
    };
    const Vec3<S> A = sheared(triangle.A);
    const Vec3<S> B = sheared(triangle.B);
    const Vec3<S> C = sheared(triangle.C);
    S U = C.y * B.z - C.z * B.y;
    S V = A.y * C.z - A.z * C.y;
    S W = B.y * A.z - B.z * A.y;
    if (U == 0 || V == 0 || W == 0) {
        const auto edge = [](const Vec3<S>& p, const Vec3<S>& q) {
            return static_cast<S>(Wider(p.y) * Wider(q.z) - Wider(p.z) * Wider(q.y));
        };
        U = edge(C, B);
        V = edge(A, C);
        W = edge(B, A);
    }
    if ((U < 0 || V < 0 || W < 0) && (U > 0 || V > 0 || W > 0)) return {};
    const S det = U + V + W;
    if (!(det != 0)) return {};
    const S t = (U * A.x + V * B.x + W * C.x) / det;
    if constexpr (with_bound) return {t > error_of_sheared_t(A, B, C, Vec3<S>(U, V, W), det), t};
    return {t >= 0, t};
}
template <class S>
Hit<S> woop(const Ray<S>& ray, const Triangle<S>& triangle) {
    return sheared_triangle<S, false>(ray, triangle);
}
/// Pharr, Jakob and Humphreys, "Physically Based Rendering" (4th ed.), 6.8.7: a hit whose t is not proven to be above 0
/// is a miss.
template <class S>
Hit<S> woop_with_bound(const Ray<S>& ray, const Triangle<S>& triangle) {
    return sheared_triangle<S, true>(ray, triangle);
}

/// GLM's function, which misses where |det| <= epsilon and leaves the sign of t to the caller.
template <class S>
Hit<S> glm_triangle(const Ray<S>& ray, const Triangle<S>& triangle) {
    glm::vec<2, S> uv(0);
    S t = 0;
    const bool hit = glm::intersectRayTriangle(ray.origin, ray.direction, triangle.A, triangle.B, triangle.C, uv, t);
    return {hit && t >= 0, t};
}

}  // namespace reference::accuracy
