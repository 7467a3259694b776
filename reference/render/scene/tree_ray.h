// A ray in the coordinates of a tree, in floats, so that eight boxes are tried at once.
//
// In these coordinates the scene lies between -1 and 1. The ray is o + τ d with 1 <= max |d| < 2; where it starts far
// outside, beyond 16, its origin is moved to where it enters the scene. So no number is much above 1, and no box is met
// beyond τ = 17.
//
// A box is tried by near = low/d - o/d and far = high/d - o/d, in floats. What rounding costs is expressed as a shift
// of the origin, where it does not depend on how steep the ray is. With u = 2^-24, |low|, |high| <= 1 and M = 1, or |o|
// if that is larger, in units of uM and relative to the true (low - o)/d:
//   1   low, rounded to a float
//   1   o, rounded to a float
//   2   low/d and o/d, as products with 1/d: u of each
//   2   their difference: u of |low - o|
//   5   1/d: u for d as a float, u for the quotient, times |low - o|, and what is of second order
// Less than 12 uM, with 2^-8 of it for an origin that is moved and then only 2^-8 beyond 1. So the origin is shifted by
// slack >= 16 uM = 2^-20 M backwards for `near` and forwards for `far`. Then near and far are bounds, and none of the
// comparisons needs a margin of its own. Doubles before that cost 2^-53 each, of |o| before it is moved and of τ: 2^-44
// of these is part of the slack, beside the uncertainty of the start. A component of d below 2^-100 is taken to be
// 2^-100: over τ <= 17 it moves the ray by less than 2^-95, and by less than 2^-62 on the way from where it started. So
// nothing is infinite, NaN, or subnormal but for products that are far below the slack.
#pragma once

#include <algorithm>
#include <bit>

#include "reference/render/scene/tree.h"

namespace reference::render {

/// The three coordinates of a point, and the last one again.
using Four [[gnu::vector_size(32)]] = double;
using FourBits [[gnu::vector_size(32)]] = std::uint64_t;
using FourFloats [[gnu::vector_size(16)]] = float;

KERNEL_INLINE Four all_of(double x) {
    return Four{x, x, x, x};
}
KERNEL_INLINE FourBits signs_of(Four p) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    return std::bit_cast<FourBits>(p) & FourBits{sign, sign, sign, sign};
}
KERNEL_INLINE Four size_of(Four p) {
    return std::bit_cast<Four>(std::bit_cast<FourBits>(p) ^ signs_of(p));
}
KERNEL_INLINE Four signed_as(Four size, FourBits signs) {
    return std::bit_cast<Four>(std::bit_cast<FourBits>(size) | signs);
}
KERNEL_INLINE double largest_of(Four p) {
    return std::max(std::max(p[0], p[1]), p[2]);
}

struct TreeRay {
    enum class Way {
        through_boxes,
        nowhere,    ///< the ray misses the scene
        everywhere  ///< the ray's numbers are beyond what the coordinates can express
    };
    Way way;
    FourFloats inverse;      ///< 1/d
    FourFloats near_shift;   ///< o/d for the sides at which the ray enters
    FourFloats far_shift;    ///< the same for those at which it leaves
    std::uint32_t enter[3];  ///< the row of Node::sides at which the ray enters
    double tau_per_t;
    double start;  ///< the τ by which the origin was moved
    double slack;

    /// The τ of t, rounded up.
    float tau(double t) const { return static_cast<float>(t * tau_per_t - start + slack); }
};

/// 2^n and 2^-n for a double from 2^n to less than 2^(n+1). 0 and infinity for one that is subnormal or infinite.
struct Powers {
    double grow;
    double shrink;
};
KERNEL_INLINE Powers powers_of(double x) {
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) & (std::uint64_t{2047} << 52U);
    return {std::bit_cast<double>(exponent), std::bit_cast<double>((std::uint64_t{2046} << 52U) - exponent)};
}

KERNEL_INLINE TreeRay tree_ray(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty) {
    const auto four_of = [](const Vec3<double>& p) { return Four{p.x, p.y, p.z, p.z}; };
    TreeRay result;
    const Four direction = four_of(ray.direction);
    const Powers powers = powers_of(largest_of(size_of(direction)));
    const double scale = tree.scale;
    result.tau_per_t = powers.grow * scale;
    Four o = (four_of(ray.origin) - four_of(tree.center)) * all_of(scale);
    const Four along = direction * all_of(powers.shrink);
    const FourBits backward = signs_of(along);
    const Four least = all_of(0x1p-100);
    const Four steepness = size_of(along) > least ? size_of(along) : least;
    const Four d = signed_as(steepness, backward);
    const double reach = largest_of(size_of(o));
    const bool is_far = reach > 16;
    result.slack = 0x1p-20 * (is_far ? 1 : std::max(reach, 1.0)) + 0x1p-44 * reach + uncertainty * scale;
    result.start = 0;
    result.way = TreeRay::Way::everywhere;
    // False for a scale that is NaN, and so for a slack that is.
    const bool is_in_range = (0x1p-400 < powers.grow) & (powers.grow < 0x1p400) & (result.slack < 0x1p-9);
    if (!is_in_range) [[unlikely]]
        return result;
    if (is_far) {
        // It leaves the scene by τ = reach + 1, along its longest component. At `start` it has yet to come between
        // -1 and 1 along the axis of the latest entry. Along another axis it is beyond 1 only if it moves away, or
        // it would enter later: then it never meets the scene.
        const Four outside = size_of(o) - all_of(1 + result.slack);
        const Four entries = (signs_of(o) ^ backward) != 0 ? outside / steepness : Four{};
        result.start = std::max(largest_of(entries), 0.0);
        o += all_of(result.start) * d;
        result.way = TreeRay::Way::nowhere;
        if ((result.start > 2 * (reach + 1)) | (largest_of(size_of(o)) > 1 + 0x1p-8)) return result;
    }
    const Four back = signed_as(all_of(result.slack), backward);
    result.inverse = FourFloats{1, 1, 1, 1} / __builtin_convertvector(d, FourFloats);
    result.near_shift = __builtin_convertvector(o + back, FourFloats) * result.inverse;
    result.far_shift = __builtin_convertvector(o - back, FourFloats) * result.inverse;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        result.enter[axis] = 2 * axis + static_cast<std::uint32_t>(backward[axis] >> 63U);
    }
    result.way = TreeRay::Way::through_boxes;
    return result;
}

}  // namespace reference::render
