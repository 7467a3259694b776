// The tree of the renderer as a textbook walks it, in floats or in doubles: slabs without a margin, and Möller and
// Trumbore's test. The nodes and leaves are the same; the boxes are the exact bounds of the faces, as floats hold them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/accuracy/mesh/mesh_hit.h"
#include "reference/accuracy/methods/triangle_methods.h"
#include "reference/render/scene/tree.h"

namespace reference::accuracy {

template <class S>
class PlainTree {
  public:
    /// Every coordinate of the tree's triangles is a float.
    explicit PlainTree(const render::Tree& tree) {
        for (const render::Leaf& leaf : tree.leaves) leaves_.push_back(plain(leaf));
        std::vector<render::Box> bounds(tree.nodes.size());
        nodes_.resize(tree.nodes.size());
        // A node stands before its children.
        for (std::size_t i = tree.nodes.size(); i-- > 0;) {
            Node& node = nodes_[i];
            for (std::size_t child = 0; child < render::children_per_node; ++child) {
                const std::uint32_t index = tree.nodes[i].children[child];
                render::Box box;
                if (!tree.nodes[i].is_missing(child)) {
                    box = index >= render::first_leaf ? bounds_of(tree.leaves[index - render::first_leaf])
                                                      : bounds[index];
                }
                node.children[child] = index;
                for (int axis = 0; axis < 3; ++axis) {
                    node.sides[2 * static_cast<std::size_t>(axis)][child] = static_cast<S>(box.low[axis]);
                    node.sides[2 * static_cast<std::size_t>(axis) + 1][child] = static_cast<S>(box.high[axis]);
                }
                bounds[i].cover(box);
            }
        }
    }

    MeshHit first_hit(const kernel::Ray<S>& ray) const {
        const Vec3<S> inverse(S(1) / ray.direction.x, S(1) / ray.direction.y, S(1) / ray.direction.z);
        MeshHit first;
        S until = HUGE_VAL;
        std::array<Open, render::deepest_tree * render::children_per_node> open;
        std::size_t count = 0;
        open[count++] = {S(0), 0};
        while (count > 0) {
            const Open here = open[--count];
            if (here.near > until) continue;
            if (here.child >= render::first_leaf) {
                visit(leaves_[here.child - render::first_leaf], ray, until, first);
            } else {
                count = add_children(nodes_[here.child], ray.origin, inverse, until, open.data(), count);
            }
        }
        return first;
    }

  private:
    struct Node {
        std::array<std::array<S, render::children_per_node>, 6> sides;  ///< by axis: lower, upper
        std::array<std::uint32_t, render::children_per_node> children;
    };
    struct PlainLeaf {
        std::array<Triangle<S>, render::objects_per_leaf> triangles;
        std::array<std::uint32_t, render::objects_per_leaf> faces;
        std::uint32_t count;
    };
    struct Open {
        S near;
        std::uint32_t child;
    };

    static PlainLeaf plain(const render::Leaf& leaf) {
        PlainLeaf result{{}, leaf.objects, leaf.count};
        for (std::size_t lane = 0; lane < render::objects_per_leaf; ++lane) {
            const Triangle<double> triangle = leaf.triangle(lane);
            result.triangles[lane] = {Vec3<S>(triangle.A), Vec3<S>(triangle.B), Vec3<S>(triangle.C)};
        }
        return result;
    }
    static render::Box bounds_of(const render::Leaf& leaf) {
        render::Box box;
        for (std::size_t lane = 0; lane < leaf.count; ++lane) box.cover(render::box_of(leaf.triangle(lane)));
        return box;
    }

    static void visit(const PlainLeaf& leaf, const kernel::Ray<S>& ray, S& until, MeshHit& first) {
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
            const Hit<S> hit = moller_trumbore(ray, leaf.triangles[lane]);
            if (!hit.hit || !(hit.t < until)) continue;
            until = hit.t;
            first = {true, leaf.faces[lane], static_cast<double>(hit.t)};
        }
    }

    /// Adds the children that the ray meets, the nearest on top. Returns how many are open then.
    static std::size_t add_children(const Node& node, const Vec3<S>& origin, const Vec3<S>& inverse, S until,
                                    Open* open, std::size_t count) {
        std::array<S, render::children_per_node> near;
        std::array<S, render::children_per_node> far;
        near.fill(0);
        far.fill(until);
        for (int axis = 0; axis < 3; ++axis) {
            const auto low = 2 * static_cast<std::size_t>(axis);
            const std::size_t enter = std::signbit(inverse[axis]) ? low + 1 : low;
            const std::size_t leave = std::signbit(inverse[axis]) ? low : low + 1;
            for (std::size_t i = 0; i < render::children_per_node; ++i) {
                const S from = (node.sides[enter][i] - origin[axis]) * inverse[axis];
                const S to = (node.sides[leave][i] - origin[axis]) * inverse[axis];
                near[i] = from > near[i] ? from : near[i];
                far[i] = to < far[i] ? to : far[i];
            }
        }
        const std::size_t bottom = count;
        for (std::size_t i = 0; i < render::children_per_node; ++i) {
            if (!(near[i] <= far[i])) continue;
            std::size_t place = count++;
            for (; place > bottom && open[place - 1].near < near[i]; --place) open[place] = open[place - 1];
            open[place] = {near[i], node.children[i]};
        }
        return count;
    }

    std::vector<Node> nodes_;
    std::vector<PlainLeaf> leaves_;
};

}  // namespace reference::accuracy
