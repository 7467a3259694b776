// The numbers whose signs decide about a ray and a cylinder; cylinder.h decides by them.
#pragma once

#include <array>

#include "reference/kernel/order.h"

namespace reference::kernel {

/// What decides about a ray and a cylinder, over intervals or exact numbers.
template <class S>
struct CylinderForm {
    HalfQuadratic<S, S, S> tube;  ///< a is 0 for a ray along the axis
    /// The ray meets the caps' planes at t = caps[0] / pace and later at t = caps[1] / pace. Where pace is 0, it runs
    /// between them if caps[0] <= 0 <= caps[1].
    std::array<S, 2> caps;
    S pace;        ///< 2 |V.y|
    bool goes_up;  ///< V.y >= 0: the bottom is the first cap
};

/// `start` is measured from the center. Vectors have x, y and z; the sign of direction.y must be known.
template <class Vector, class S>
CylinderForm<S> cylinder_form(const Vector& start, const Vector& direction, const S& radius, const S& height) {
    const bool goes_up = !(sign_of(direction.y) < 0);
    const S twice_y = start.y + start.y;
    const S twice_Vy = direction.y + direction.y;
    const S y = goes_up ? twice_y : S() - twice_y;  // along the way
    const S pace = goes_up ? twice_Vy : S() - twice_Vy;
    return {{direction.x * direction.x + direction.z * direction.z, direction.x * start.x + direction.z * start.z,
             start.x * start.x + start.z * start.z - radius * radius},
            {S() - (height + y), height - y},
            pace,
            goes_up};
}

}  // namespace reference::kernel
