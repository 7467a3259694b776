// A ray in the coordinates of a tree, in floats, so that eight boxes are tried at once.
//
// In these coordinates the scene lies between -1 and 1. The ray is o + τ d with 1 <= max |d| < 2; its origin is moved
// to where it enters the scene, if it starts outside. So every number is near 1, and no box is met beyond τ = 3.
//
// A box is tried by near = low/d - o/d and far = high/d - o/d, in floats. What rounding costs is expressed as a shift
// of the origin, where it does not depend on how steep the ray is. In units of u = 2^-24, with |low|, |high| <= 1 and
// |o| <= 1 + 2^-8, and relative to the true (low - o)/d:
//   1   low, rounded to a float
//   1   o, rounded to a float
//   2   low/d and o/d, as products with 1/d: u of each
//   2   their difference: u of |low - o|
//   5   1/d: u for d as a float, u for the quotient, times |low - o|, and what is of second order
// Less than 12 u with 2^-8 of it for |o| > 1. So the origin is shifted by slack >= 16 u = 2^-20 backwards for `near`
// and forwards for `far`. Then near and far are bounds, and none of the comparisons needs a margin of its own. Doubles
// before that cost 2^-53 each, of |o| before it is moved and of τ: 2^-46 of these is part of the slack, beside the
// uncertainty of the start. A component of d below 2^-100 is taken to be 2^-100: over τ <= 3 it moves the ray by less
// than 2^-98. So nothing is infinite, NaN, or subnormal but for products that are far below the slack.
#pragma once

#include <algorithm>
#include <bit>

#include "reference/render/scene/tree.h"

namespace reference::render {

struct TreeRay {
    enum class Way {
        through_boxes,
        nowhere,    ///< the ray misses the scene
        everywhere  ///< the ray's numbers are beyond what the coordinates can express
    };
    Way way;
    float inverse[3];        ///< 1/d
    float near_shift[3];     ///< o/d for the sides at which the ray enters
    float far_shift[3];      ///< the same for those at which it leaves
    std::uint32_t enter[3];  ///< the row of Node::sides at which the ray enters
    double tau_per_t;
    double start;  ///< the τ by which the origin was moved
    double slack;

    /// The τ of t, rounded up.
    float tau(double t) const { return static_cast<float>(t * tau_per_t - start + slack); }
};

/// The exponent of a positive double; below -1022 for 0 and subnormal numbers, above 1023 for infinity and NaN.
inline int exponent_of(double x) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U) - 1023;
}
/// 2^exponent, from -1022 to 1023.
inline double power_of_2(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

KERNEL_INLINE TreeRay tree_ray(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty) {
    constexpr double least = 0x1p-100;
    TreeRay result;
    double o[3];
    double d[3];
    const double size = std::max({std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)});
    const int exponent = exponent_of(size);
    result.way = TreeRay::Way::everywhere;
    if (!(-900 < exponent && exponent < 900)) return result;
    const double shrink = power_of_2(-exponent);
    result.tau_per_t = power_of_2(exponent) * tree.scale;
    double reach = 0;
    for (int i = 0; i < 3; ++i) {
        o[i] = (ray.origin[i] - tree.center[i]) * tree.scale;
        const double along = ray.direction[i] * shrink;
        d[i] = std::copysign(std::max(std::abs(along), least), along);
        reach = std::max(reach, std::abs(o[i]));
    }
    result.start = 0;
    result.slack = 0x1p-20 + 0x1p-44 * reach + uncertainty * tree.scale;
    if (reach > 1) {
        // The ray leaves the scene by τ = reach + 1, along its longest component.
        for (int i = 0; i < 3; ++i) {
            if ((o[i] > 1 && d[i] < 0) || (o[i] < -1 && d[i] > 0)) {
                result.start = std::max(result.start, (std::abs(o[i]) - 1 - result.slack) / std::abs(d[i]));
            }
        }
        if (result.start > 2 * (reach + 1)) {
            result.way = TreeRay::Way::nowhere;
            return result;
        }
        for (int i = 0; i < 3; ++i) o[i] += result.start * d[i];
    }
    const bool is_in_range = result.slack < 0x1p-9 && 0x1p-900 < result.tau_per_t && result.tau_per_t < 0x1p900;
    if (!is_in_range) return result;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(o[i]) > 1 + 0x1p-8) {
            result.way = TreeRay::Way::nowhere;
            return result;
        }
        const bool backward = d[i] < 0;
        const double back = std::copysign(result.slack, d[i]);
        result.inverse[i] = 1 / static_cast<float>(d[i]);
        result.near_shift[i] = static_cast<float>(o[i] + back) * result.inverse[i];
        result.far_shift[i] = static_cast<float>(o[i] - back) * result.inverse[i];
        result.enter[i] = static_cast<std::uint32_t>(2 * i + (backward ? 1 : 0));
    }
    result.way = TreeRay::Way::through_boxes;
    return result;
}

}  // namespace reference::render
