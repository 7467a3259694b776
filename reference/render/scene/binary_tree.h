// A binary tree of boxes around objects: each box is cut in two where a ray is expected to try the fewest leaves, by
// the surface area heuristic of MacDonald and Booth (1990), at the bounds of bins (Wald, 2007).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "reference/render/scene/huge_pages.h"

namespace reference::render {

/// By axis. The fourth number means nothing, and is nothing that is slow to reckon with.
using AxisFloats [[gnu::vector_size(16)]] = float;

/// A box whose coordinates lie between -1 and 1.
struct FloatBox {
    AxisFloats low{HUGE_VALF, HUGE_VALF, HUGE_VALF, 0};
    AxisFloats high{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF, 0};

    void cover(const FloatBox& other) {
        low = low < other.low ? low : other.low;
        high = high > other.high ? high : other.high;
    }

    float half_area() const {
        const AxisFloats size = high - low;
        return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
};

/// The number stands where the fourth number of `low` would: a tree is built as fast as memory brings the objects.
class BoxedObject {
  public:
    BoxedObject(const std::array<float, 3>& low, const std::array<float, 3>& high, std::uint32_t number)
        : box_{{low[0], low[1], low[2], std::bit_cast<float>(number)}, {high[0], high[1], high[2], 0}} {}

    std::uint32_t number() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box_.low[3])); }
    /// Without the number, which as a float may be too small for fast sums.
    FloatBox box() const {
        using Bits [[gnu::vector_size(16)]] = std::uint32_t;
        constexpr std::uint32_t all = 0xffffffff;
        return {std::bit_cast<AxisFloats>(std::bit_cast<Bits>(box_.low) & Bits{all, all, all, 0}), box_.high};
    }

  private:
    FloatBox box_;
};

struct BinaryNode {
    FloatBox box;
    std::uint32_t first_object;  ///< in the order that the objects are in by now
    std::uint32_t object_count;
    std::uint32_t halves;  ///< the first of two nodes; 0 for a leaf

    bool is_leaf() const { return halves == 0; }
};

/// Below these levels a box is cut in the middle of its objects, so that a tree of 2^32 objects has at most
/// `deepest_tree` levels.
constexpr std::size_t most_levels_by_cost = 96;
constexpr std::size_t deepest_tree = most_levels_by_cost + 32;

/// Cuts boxes of more than `most_in_leaf` objects, and puts the objects in the order of the leaves. The root is the
/// first node, and a node stands before its halves. There is at least one object. The tree is the same on every
/// machine.
InHugePages<BinaryNode> binary_tree(std::span<BoxedObject> objects, std::size_t most_in_leaf,
                                    std::size_t levels_by_cost = most_levels_by_cost);

}  // namespace reference::render
