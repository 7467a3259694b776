// Points in the world and spots on the page, for computing pictures.
#pragma once

#include <cmath>

#include "reference/numbers/vector.h"

namespace harness::report::picture {

using Point = reference::Vec3<double>;
using Spot = Point;  ///< on the page: y counts downward, z is 0

inline double distance(const Point& point, const Point& other) {
    return reference::length(other - point);
}

inline bool is_finite(const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

struct Segment {
    Point from;
    Point to;
};

/// A rectangle on the page.
struct Box {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;

    Spot low() const { return {left, top, 0}; }
    Spot high() const { return {right, bottom, 0}; }
    Spot middle() const { return (low() + high()) / 2.0; }
    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool contains(const Spot& spot) const {
        return left <= spot.x && spot.x <= right && top <= spot.y && spot.y <= bottom;
    }
    bool overlaps(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

}  // namespace harness::report::picture
