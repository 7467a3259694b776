#include "reference/render/scene/tree.h"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <utility>

#include "reference/render/scene/instructions.h"

namespace reference::render {
namespace {

/// Chooses which boxes of a binary tree become nodes of eight places, so that the areas of these add up to the least:
/// the larger a box, the more rays meet it (Ylitie, Karras and Laine, 2017). Every place is taken that can be.
class Places {
  public:
    explicit Places(std::span<const BinaryNode> binary) : binary_(binary) {
        of_first_half_.resize(binary.size());
        choose(0);
    }

    /// The binary nodes that stand in the places of the node that a binary node becomes.
    using Children = boost::container::static_vector<std::uint32_t, children_per_node>;
    Children children_of(std::uint32_t node) const {
        Children children;
        add(node, children_per_node, children);
        return children;
    }

  private:
    template <class T>
    using ByPlaces = std::array<T, children_per_node + 1>;

    /// The least sum of the areas of nodes at and below a binary node, by the places that it may take.
    ByPlaces<float> choose(std::uint32_t here) {
        ByPlaces<float> areas{};
        const BinaryNode& node = binary_[here];
        if (node.is_leaf()) return areas;
        const ByPlaces<float> first = choose(node.halves);
        const ByPlaces<float> second = choose(node.halves + 1);
        for (std::size_t places = 2; places <= children_per_node; ++places) {
            areas[places] = HUGE_VALF;
            for (std::size_t i = 1; i < places; ++i) {
                const float area = first[i] + second[places - i];
                if (area < areas[places]) {
                    areas[places] = area;
                    of_first_half_[here][places] = static_cast<std::uint8_t>(i);
                }
            }
        }
        areas[1] = node.box.half_area() + areas[children_per_node];
        return areas;
    }

    void add(std::uint32_t here, std::size_t places, Children& children) const {
        const BinaryNode& node = binary_[here];
        if (node.is_leaf() || places == 1) {
            children.push_back(here);
        } else {
            const std::size_t of_first = of_first_half_[here][places];
            add(node.halves, of_first, children);
            add(node.halves + 1, places - of_first, children);
        }
    }

    std::span<const BinaryNode> binary_;
    InHugePages<ByPlaces<std::uint8_t>> of_first_half_;
};

class Builder {
  public:
    Builder(Tree& tree, std::span<const BoxedObject> objects, std::span<const BinaryNode> binary,
            std::span<const kernel::PreparedTriangle<double>> triangles, std::uint32_t first_triangle)
        : tree_(tree),
          objects_(objects),
          binary_(binary),
          places_(binary),
          triangles_(triangles),
          first_triangle_(first_triangle) {}

    void build() {
        tree_.leaves.reserve(binary_.size() / 2 + 1);
        tree_.nodes.reserve(binary_.size() / 8 + 1);
        tree_.nodes.push_back(empty_node());
        fill(0, 0);
    }

  private:
    static Node empty_node() {
        Node node{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.sides[2 * axis].fill(HUGE_VALF);
            node.sides[2 * axis + 1].fill(-HUGE_VALF);
        }
        return node;
    }

    /// The children of a node stand one after the other, as rays read them.
    void fill(std::size_t here, std::uint32_t from) {
        const Places::Children children = places_.children_of(from);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const BinaryNode& child = binary_[children[i]];
            Node& node = tree_.nodes[here];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.sides[2 * axis][i] = child.box.low[axis];
                node.sides[2 * axis + 1][i] = child.box.high[axis];
            }
            if (child.is_leaf()) {
                node.children[i] = first_leaf + static_cast<std::uint32_t>(tree_.leaves.size());
                add_leaf(objects_.subspan(child.first_object, child.object_count));
            } else {
                node.children[i] = static_cast<std::uint32_t>(tree_.nodes.size());
                tree_.nodes.push_back(empty_node());
            }
        }
        for (std::size_t i = 0; i < children.size(); ++i) {
            if (!binary_[children[i]].is_leaf()) fill(tree_.nodes[here].children[i], children[i]);
        }
    }

    void add_leaf(std::span<const BoxedObject> objects) {
        Leaf& leaf = tree_.leaves.emplace_back();
        leaf.count = static_cast<std::uint32_t>(objects.size());
        for (std::size_t lane = 0; lane < objects_per_leaf; ++lane) {
            const std::uint32_t object = objects[lane < objects.size() ? lane : 0].number();
            leaf.objects[lane] = object;
            const Triangle<double> triangle = triangle_or_nan(object);
            for (int i = 0; i < 3; ++i) {
                const auto axis = static_cast<std::size_t>(i);
                leaf.corners[0][axis][lane] = triangle.A[i];
                leaf.corners[1][axis][lane] = triangle.B[i];
                leaf.corners[2][axis][lane] = triangle.C[i];
            }
        }
    }

    Triangle<double> triangle_or_nan(std::uint32_t object) const {
        const std::uint32_t number = object - first_triangle_;  // wraps around below the first
        if (number < triangles_.size()) return triangles_[number].triangle;
        const Vec3<double> unknown(NAN, NAN, NAN);
        return {unknown, unknown, unknown};
    }

    Tree& tree_;
    std::span<const BoxedObject> objects_;
    std::span<const BinaryNode> binary_;
    Places places_;
    std::span<const kernel::PreparedTriangle<double>> triangles_;
    std::uint32_t first_triangle_;
};

/// Puts the box between -1 and 1 in every coordinate.
void set_coordinates(Tree& tree, const Box& box) {
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis) {
        tree.center[axis] = box.low[axis] / 2 + box.high[axis] / 2;
        reach = std::max({reach, box.high[axis] - tree.center[axis], tree.center[axis] - box.low[axis]});
    }
    tree.scale = 0x1p-400 < reach && reach < 0x1p400 ? std::ldexp(1.0, -(std::ilogb(reach) + 1)) : NAN;
}

}  // namespace

Triangle<double> Leaf::triangle(std::size_t lane) const {
    const auto corner = [&](std::size_t i) {
        return Vec3<double>(corners[i][0][lane], corners[i][1][lane], corners[i][2][lane]);
    };
    return {corner(0), corner(1), corner(2)};
}

Box box_of(const Sphere<double>& sphere) {
    Box box;
    for (int i = 0; i < 3; ++i) {
        box.low[i] = std::nextafter(sphere.center[i] - sphere.radius, -HUGE_VAL);
        box.high[i] = std::nextafter(sphere.center[i] + sphere.radius, HUGE_VAL);
    }
    return box;
}

Box box_of(const Triangle<double>& triangle) {
    Box box;
    for (const Vec3<double>& vertex : {triangle.A, triangle.B, triangle.C}) box.cover({vertex, vertex});
    return box;
}

Box box_of(const Cylinder<double>& cylinder) {
    const Vec3<double> reach(cylinder.radius, cylinder.height / 2, cylinder.radius);
    Box box;
    for (int i = 0; i < 3; ++i) {
        box.low[i] = std::nextafter(cylinder.center[i] - reach[i], -HUGE_VAL);
        box.high[i] = std::nextafter(cylinder.center[i] + reach[i], HUGE_VAL);
    }
    return box;
}

Tree build_tree(std::span<const Box> boxes, std::span<const kernel::PreparedTriangle<double>> triangles,
                std::uint32_t first_triangle) {
    Box whole;
    for (const Box& box : boxes) whole.cover(box);
    Tree tree{};
    tree.instructions = best_instructions();
    set_coordinates(tree, whole);
    InHugePages<BoxedObject> objects;
    objects.reserve(boxes.size());
    const double scale = std::isnan(tree.scale) ? 0 : tree.scale;  // then no ray looks at a box
    for (const Box& box : boxes) {
        const auto in_tree = [&](const Vec3<double>& p) {
            const Vec3<double> moved = (p - tree.center) * scale;
            return std::array{static_cast<float>(moved.x), static_cast<float>(moved.y), static_cast<float>(moved.z)};
        };
        objects.emplace_back(in_tree(box.low), in_tree(box.high), static_cast<std::uint32_t>(objects.size()));
    }
    const InHugePages<BinaryNode> binary = binary_tree(objects, objects_per_leaf);
    Builder(tree, objects, binary, triangles, first_triangle).build();
    return tree;
}

}  // namespace reference::render
