// Points and vectors of the world, as pictures compute with them.
#pragma once

#include <cmath>

#include "reference/numbers/vector.h"

namespace harness::report::picture {

using Point = reference::Vec3<double>;

inline double distance(const Point& one, const Point& other) {
    return std::hypot(one.x - other.x, one.y - other.y, one.z - other.z);
}

inline bool is_finite(const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

}  // namespace harness::report::picture
