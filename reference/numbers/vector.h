// Three-dimensional vectors and 3x3 and 4x4 matrices over any scalar S, in GLM's types and GLM's column order.
// GLM's own dot, cross, length and normalize accept built-in scalars only, so the generic ones are here.
#pragma once

#include <cmath>
#include <compare>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "reference/numbers/arithmetic.h"

#ifndef GLM_FORCE_XYZW_ONLY
#error "Define GLM_FORCE_XYZW_ONLY for the whole project: GLM's unions refuse scalars that are classes."
#endif

namespace reference {

template <class S>
using Vec3 = glm::vec<3, S>;
template <class S>
using Vec4 = glm::vec<4, S>;
template <class S>
using Mat3 = glm::mat<3, 3, S>;
template <class S>
using Mat4 = glm::mat<4, 4, S>;

template <class S>
S dot(const Vec3<S>& p, const Vec3<S>& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

template <class S>
Vec3<S> cross(const Vec3<S>& p, const Vec3<S>& q) {
    return Vec3<S>(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
}

template <class S>
S length(const Vec3<S>& p) {
    using std::sqrt;
    return sqrt(dot(p, p));
}

template <class S>
Vec3<S> scaled(const Vec3<S>& p, const S& factor) {
    return Vec3<S>(p.x * factor, p.y * factor, p.z * factor);
}

/// The unit vector along p; NaN in every component when p is the zero vector.
template <class S>
Vec3<S> normalized(const Vec3<S>& p) {
    const S norm = length(p);
    return Vec3<S>(p.x / norm, p.y / norm, p.z / norm);
}

/// The sign of x: less, equivalent or greater than zero, unordered where x cannot tell (NaN, or an interval around
/// zero). A scalar class comes with its own overload; every decision of the stages goes through it.
inline std::partial_ordering sign_of(float x) {
    return x <=> 0.0F;
}
inline std::partial_ordering sign_of(double x) {
    return x <=> 0.0;
}
inline std::partial_ordering sign_of(long double x) {
    return x <=> 0.0L;
}

}  // namespace reference
