// The walk through a tree, for any vector instructions. `Vectors` has
// - Vectors::Boxes: made from a TreeRay; meets(node, until, near) gives the children that the ray may meet before the τ
//   `until`, as bits, and the τ from which on it may meet each of them
// - Vectors::Triangles: made from the ray and the uncertainty of its start; hits(leaf, until, t) says which lanes are
//   known to be hit at a t up to `until`, and of which lanes nothing is known
// and only compiled code that no other file compiles, since instructions differ: see walk_avx2.cpp.
#pragma once

#include "reference/render/scene/tree_ray.h"
#include "reference/render/scene/visitor.h"

namespace reference::render {

struct HitLanes {
    unsigned hits;
    unsigned open;
};

/// A child that is still to be visited.
struct OpenChild {
    float near;
    std::uint32_t child;
};

/// Children that are still to be visited, the nearest of those found together on top. Each is fetched from memory while
/// others are visited.
class OpenChildren {
  public:
    KERNEL_INLINE OpenChildren(const Node* nodes, const Leaf* leaves) : nodes_(nodes), leaves_(leaves) {}

    bool is_empty() const { return count_ == 0; }
    OpenChild take() { return open_[--count_]; }

    /// Adds the children of the bits, but for the nearest one, which it returns.
    KERNEL_INLINE std::uint32_t add_all_but_nearest(const Node& node, unsigned bits, const float* near) {
        const auto first = static_cast<unsigned>(__builtin_ctz(bits));
        bits &= bits - 1;
        if (bits == 0) return node.children.data()[first];
        const auto second = static_cast<unsigned>(__builtin_ctz(bits));
        // Without a branch, which nobody could predict.
        const unsigned swap = (first ^ second) & -static_cast<unsigned>(near[second] < near[first]);
        OpenChild nearest = child(node, first ^ swap, near);
        const std::uint32_t bottom = count_;
        open_[count_++] = child(node, second ^ swap, near);
        for (bits &= bits - 1; bits != 0; bits &= bits - 1) {
            OpenChild next = child(node, static_cast<unsigned>(__builtin_ctz(bits)), near);
            if (next.near < nearest.near) std::swap(next, nearest);
            std::uint32_t place = count_++;
            for (; place > bottom && open_[place - 1].near < next.near; --place) open_[place] = open_[place - 1];
            open_[place] = next;
        }
        return nearest.child;
    }

  private:
    KERNEL_INLINE OpenChild child(const Node& node, unsigned i, const float* near) const {
        const std::uint32_t child = node.children.data()[i];
        const void* const place = child >= first_leaf ? static_cast<const void*>(leaves_ + (child - first_leaf))
                                                      : static_cast<const void*>(nodes_ + child);
        constexpr std::size_t cache_line = 64;
        for (std::size_t at = 0; at < sizeof(Leaf); at += cache_line) {
            __builtin_prefetch(static_cast<const char*>(place) + at);
        }
        return {near[i], child};
    }

    const Node* nodes_;
    const Leaf* leaves_;
    std::uint32_t count_ = 0;
    OpenChild open_[deepest_tree * children_per_node];
};

template <class Vectors>
KERNEL_INLINE bool visit_leaf(const typename Vectors::Triangles& triangles, const Leaf& leaf, double& until,
                              Visitor& visitor) {
    alignas(32) Lanes t;
    const HitLanes found = triangles.hits(leaf, until, t);
    if ((found.hits | found.open) == 0) return false;
    return visitor.visit({leaf, found.hits, found.open, t}, until);
}

template <class Vectors>
bool walk_everywhere(const Tree& tree, const typename Vectors::Triangles& triangles, double until, Visitor& visitor) {
    for (const Leaf& leaf : tree.leaves) {
        if (visit_leaf<Vectors>(triangles, leaf, until, visitor)) return true;
    }
    return false;
}

template <class Vectors>
KERNEL_INLINE bool walk_with(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until,
                             Visitor& visitor) {
    const TreeRay in_tree = tree_ray(tree, ray, uncertainty);
    if (in_tree.way == TreeRay::Way::nowhere) return false;
    const typename Vectors::Triangles triangles(ray, uncertainty);
    if (in_tree.way == TreeRay::Way::everywhere) return walk_everywhere<Vectors>(tree, triangles, until, visitor);
    const typename Vectors::Boxes boxes(in_tree);
    const Node* const nodes = tree.nodes.data();
    const Leaf* const leaves = tree.leaves.data();
    float until_tau = in_tree.tau(until);
    OpenChildren open(nodes, leaves);
    std::uint32_t here = 0;
    while (true) {
        if (here >= first_leaf) {
            const double before = until;
            if (visit_leaf<Vectors>(triangles, leaves[here - first_leaf], until, visitor)) return true;
            if (until != before) until_tau = in_tree.tau(until);
        } else {
            alignas(32) float near[children_per_node];
            const unsigned met = boxes.meets(nodes[here], until_tau, near);
            if (met != 0) {
                here = open.add_all_but_nearest(nodes[here], met, near);
                continue;
            }
        }
        OpenChild next;
        do {
            if (open.is_empty()) return false;
            next = open.take();
        } while (!(next.near <= until_tau));
        here = next.child;
    }
}

bool walk_portable(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until,
                   Visitor& visitor);
#ifdef __x86_64__
/// Requires a processor with AVX2.
bool walk_avx2(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until, Visitor& visitor);
#endif

}  // namespace reference::render
