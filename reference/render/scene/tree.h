// A tree of boxes around the objects of a scene, so that a ray tries few of them: up to eight boxes a node, up to four
// objects a leaf, as wide as the vector instructions that walk.h tries them with. No hit is lost by rounding:
// tree_ray.h derives what the rounding of a box and of a ray may cost, and allows for it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/kernel/ray.h"
#include "reference/kernel/triangle.h"
#include "reference/render/scene/binary_tree.h"
#include "reference/render/scene/instructions.h"

namespace reference::render {

struct Box {
    Vec3<double> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Vec3<double> high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    void cover(const Box& other) {
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], other.low[i]);
            high[i] = std::max(high[i], other.high[i]);
        }
    }
};

/// A sphere's and a cylinder's bounds are rounded outward; a triangle's are coordinates of its vertices.
Box box_of(const Sphere<double>& sphere);
Box box_of(const Triangle<double>& triangle);
Box box_of(const Cylinder<double>& cylinder);

constexpr std::size_t children_per_node = 8;
constexpr std::size_t objects_per_leaf = 4;

/// One number of each object of a leaf.
using Lanes = std::array<double, objects_per_leaf>;

/// The objects of a leaf. Those beyond `count` are copies of the first. An object that is no triangle has NaN corners,
/// so that no filter knows anything of it.
struct alignas(64) Leaf {
    std::array<std::array<Lanes, 3>, 3> corners;  ///< A, B, C, each by coordinate
    std::array<std::uint32_t, objects_per_leaf> objects;
    std::uint32_t count;

    Triangle<double> triangle(std::size_t lane) const;
};

struct alignas(64) Node {
    /// By axis the lower sides, then the upper sides, in the tree's coordinates. No ray meets a missing child, whose
    /// lower sides are above its upper ones.
    std::array<std::array<float, children_per_node>, 6> sides;
    std::array<std::uint32_t, children_per_node> children;  ///< a node, or a leaf + first_leaf

    bool is_missing(std::size_t child) const { return sides[0][child] > sides[1][child]; }
};

constexpr std::uint32_t first_leaf = std::uint32_t{1} << 31U;

/// The tree's coordinates are (p - center) * scale, from -1 to 1 within the scene; scale is a power of 2.
struct Tree {
    Vec3<double> center;
    double scale;             ///< NaN for a scene of a size that the coordinates can't express
    InHugePages<Node> nodes;  ///< the root first
    InHugePages<Leaf> leaves;
    Instructions instructions;
};

/// A box for each object; there is at least one, and at most first_leaf. Triangles are the objects from
/// `first_triangle` on. The tree is the same on every machine, but for its instructions. A node stands before its
/// children.
Tree build_tree(std::span<const Box> boxes, std::span<const kernel::PreparedTriangle<double>> triangles,
                std::uint32_t first_triangle);

}  // namespace reference::render
