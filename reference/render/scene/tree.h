// A tree of boxes around the objects of a scene, so that a ray tries few of them. No hit is lost by rounding: a box
// contains its objects as exact geometry, and the test of a ray with a box allows for its own rounding errors.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/kernel/ray.h"

namespace reference::render {

struct Box {
    Vec3<double> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Vec3<double> high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    void cover(const Box& other);
    double half_area() const;
};

/// A sphere's and a cylinder's bounds are rounded outward; a triangle's are coordinates of its vertices.
Box box_of(const Sphere<double>& sphere);
Box box_of(const Triangle<double>& triangle);
Box box_of(const Cylinder<double>& cylinder);

struct Node {
    Box box;
    std::uint32_t first;  ///< inner node: its second child (the first is the next node); leaf: its first object
    std::uint32_t count;  ///< leaf: the number of its objects; inner node: 0
    std::uint32_t axis;   ///< inner node: the axis along which its children lie
};

struct Tree {
    std::vector<Node> nodes;             ///< the root first
    std::vector<std::uint32_t> objects;  ///< in the leaves' order
};

/// boxes[i] is the box of object i; there is at least one. The tree is the same on every machine.
Tree build_tree(std::span<const Box> boxes);

/// The greatest depth of a tree. The stack for walking through a tree needs no more.
constexpr std::size_t deepest_tree = 64;

/// A ray prepared for tests with boxes. The ray may start anywhere within `uncertainty` of its origin in every
/// coordinate.
class BoxRay {
  public:
    BoxRay(const kernel::Ray<double>& ray, double uncertainty) {
        for (int i = 0; i < 3; ++i) {
            const double d = ray.direction[i];
            // Below this the quotient may overflow, and a product with it would not be a bound. NaN passes all boxes.
            inverse_[i] = std::abs(d) < 0x1p-900 && d != 0 ? NAN : 1 / d;
            backward_[i] = std::signbit(d);
            const double towards = backward_[i] ? -uncertainty : uncertainty;
            const double slack = std::abs(ray.origin[i]) * (uncertainty > 0 ? 0x1p-52 : 0);
            near_origin_[i] = ray.origin[i] + towards + (backward_[i] ? -slack : slack);
            far_origin_[i] = ray.origin[i] - towards - (backward_[i] ? -slack : slack);
        }
    }

    bool goes_backward(std::uint32_t axis) const { return backward_[axis]; }

    /// Whether the ray may meet the box at a t from 0 to `until`. Each bound of t is off by 3u of itself at most, and
    /// by less than 2^-1000 where it underflows. A comparison with NaN, e.g. where a ray runs within a box's side,
    /// leaves the bounds as they are.
    bool may_meet(const Box& box, double until) const {
        double from = 0;
        double to = until;
        for (int i = 0; i < 3; ++i) {
            const double near = ((backward_[i] ? box.high[i] : box.low[i]) - near_origin_[i]) * inverse_[i];
            const double far = ((backward_[i] ? box.low[i] : box.high[i]) - far_origin_[i]) * inverse_[i];
            from = near > from ? near : from;
            to = far < to ? far : to;
        }
        return !(from > to * (1 + 0x1p-48) + 0x1p-1000);
    }

  private:
    double inverse_[3];
    double near_origin_[3];
    double far_origin_[3];
    bool backward_[3];
};

}  // namespace reference::render
