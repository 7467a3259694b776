// Products of vectors in which every product that is added to something is fused with the sum.
#pragma once

#include <cmath>

#include "reference/numbers/vector.h"

namespace reference::accuracy {

template <class S>
S fused_dot(const Vec3<S>& p, const Vec3<S>& q) {
    return std::fma(p.x, q.x, std::fma(p.y, q.y, p.z * q.z));
}

template <class S>
Vec3<S> fused_cross(const Vec3<S>& p, const Vec3<S>& q) {
    return Vec3<S>(std::fma(p.y, q.z, -(p.z * q.y)), std::fma(p.z, q.x, -(p.x * q.z)),
                   std::fma(p.x, q.y, -(p.y * q.x)));
}

}  // namespace reference::accuracy
