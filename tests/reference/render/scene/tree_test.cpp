// A tree holds every object once, in boxes around it, is never too deep, and its nodes are as small as they can be.
#include "reference/render/scene/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "reference/accuracy/rays/random_numbers.h"

namespace {

using namespace reference;
using namespace reference::render;
using accuracy::Random;

std::vector<Box> scattered_boxes(Random& random, std::size_t count) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
        const Vec3<double> corner = random.point(1);
        box.cover({corner, corner});
        const Vec3<double> other = corner + random.point(random.whole(0, 5) == 0 ? 0.5 : 0.02);
        box.cover({other, other});
    }
    return boxes;
}

/// Each box is smaller than the one before by the factor and lies nearer to 0.
std::vector<Box> dwindling_boxes(std::size_t count, double factor) {
    std::vector<Box> boxes(count);
    double size = 1;
    for (Box& box : boxes) {
        box = {{size, size, size}, {size * 1.01, size * 1.01, size * 1.01}};
        size *= factor;
    }
    return boxes;
}

Box side_box(const Node& node, std::size_t child) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = node.sides[2 * static_cast<std::size_t>(axis)][child];
        box.high[axis] = node.sides[2 * static_cast<std::size_t>(axis) + 1][child];
    }
    return box;
}

void expect_within(const Box& box, const Box& around) {
    Box both = around;
    both.cover(box);
    EXPECT_TRUE(both.low == around.low && both.high == around.high);
}

/// Calls visit(leaf, box of the leaf, depth) for each leaf, and expects boxes to lie in the boxes around them.
void for_each_leaf(const Tree& tree, const auto& visit, std::uint32_t here = 0, std::size_t depth = 1,
                   const Box& around = {{-1, -1, -1}, {1, 1, 1}}) {
    const Node& node = tree.nodes[here];
    for (std::size_t i = 0; i < children_per_node; ++i) {
        if (node.is_missing(i)) continue;
        const Box box = side_box(node, i);
        expect_within(box, around);
        if (node.children[i] >= first_leaf) {
            visit(tree.leaves[node.children[i] - first_leaf], box, depth);
        } else {
            EXPECT_GT(node.children[i], here);
            for_each_leaf(tree, visit, node.children[i], depth + 1, box);
        }
    }
}

Vec3<double> in_tree(const Tree& tree, const Vec3<double>& p) {
    const Vec3<double> moved = (p - tree.center) * tree.scale;
    return {static_cast<float>(moved.x), static_cast<float>(moved.y), static_cast<float>(moved.z)};
}

void expect_to_hold_all(const std::vector<Box>& boxes) {
    const Tree tree = build_tree(boxes, {}, 0);
    std::vector<int> times(boxes.size());
    for_each_leaf(tree, [&](const Leaf& leaf, const Box& around, std::size_t depth) {
        ASSERT_GE(leaf.count, 1U);
        ASSERT_LE(leaf.count, objects_per_leaf);
        EXPECT_LE(depth, deepest_tree);
        for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            const Box& box = boxes[leaf.objects[lane]];
            expect_within({in_tree(tree, box.low), in_tree(tree, box.high)}, around);
            ++times[leaf.objects[lane]];
        }
    });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(boxes.size()));
}

TEST(Tree, HoldsEachObjectOnceInBoxesAroundIt) {
    Random random(1);
    for (const std::size_t count : {1U, 2U, 4U, 5U, 8U, 9U, 33U, 1000U, 20'000U}) {
        expect_to_hold_all(scattered_boxes(random, count));
    }
}

TEST(Tree, HoldsObjectsThatNoCutTellsApart) {
    expect_to_hold_all(std::vector<Box>(1000, Box{{0, 0, 0}, {1, 1, 1}}));
}

/// The binary tree that build_tree() starts from.
struct Binary {
    InHugePages<BinaryNode> nodes;
    std::map<std::uint32_t, double> known;

    /// The least sum of the areas of nodes of up to eight children, by trying all: of the node that stands at `node`,
    /// and of what is below it.
    double least_area(std::uint32_t node) {
        if (nodes[node].is_leaf()) return 0;
        if (const auto before = known.find(node); before != known.end()) return before->second;
        const double below = least_area_below({nodes[node].halves, nodes[node].halves + 1}, 0);
        return known[node] = static_cast<double>(nodes[node].box.half_area()) + below;
    }

  private:
    /// Of these children, of which those before `next` stay as they are.
    double least_area_below(const std::vector<std::uint32_t>& children, std::size_t next) {
        if (next == children.size()) {
            double area = 0;
            for (const std::uint32_t child : children) area += least_area(child);
            return area;
        }
        double least = least_area_below(children, next + 1);
        const BinaryNode& node = nodes[children[next]];
        if (!node.is_leaf() && children.size() < children_per_node) {
            std::vector<std::uint32_t> opened = children;
            opened[next] = node.halves;
            opened.insert(opened.begin() + static_cast<std::ptrdiff_t>(next) + 1, node.halves + 1);
            least = std::min(least, least_area_below(opened, next));
        }
        return least;
    }
};

Binary binary_of(const std::vector<Box>& boxes, const Tree& tree, std::size_t levels_by_cost = most_levels_by_cost) {
    std::vector<BoxedObject> objects;
    for (const Box& box : boxes) {
        const auto floats = [&](const Vec3<double>& p) {
            const Vec3<double> moved = in_tree(tree, p);
            return std::array{static_cast<float>(moved.x), static_cast<float>(moved.y), static_cast<float>(moved.z)};
        };
        objects.emplace_back(floats(box.low), floats(box.high), static_cast<std::uint32_t>(objects.size()));
    }
    return {binary_tree(objects, objects_per_leaf, levels_by_cost), {}};
}

std::size_t depth_of(const Binary& binary, std::uint32_t node = 0) {
    if (binary.nodes[node].is_leaf()) return 1;
    const std::uint32_t halves = binary.nodes[node].halves;
    return 1 + std::max(depth_of(binary, halves), depth_of(binary, halves + 1));
}

TEST(BinaryTree, IsCutInTheMiddleOfObjectsOnceItIsDeep) {
    const std::vector<Box> boxes = dwindling_boxes(8192, 0.99);
    const Tree tree = build_tree(boxes, {}, 0);
    EXPECT_GT(depth_of(binary_of(boxes, tree)), 16U);
    EXPECT_LE(depth_of(binary_of(boxes, tree, 4)), 4U + 12U);  // 2^11 leaves of 4
}

double area_of_nodes(const Tree& tree) {
    double area = 0;
    for (const Node& node : tree.nodes) {
        Box box;
        for (std::size_t i = 0; i < children_per_node; ++i) {
            if (!node.is_missing(i)) box.cover(side_box(node, i));
        }
        const Vec3<double> size = box.high - box.low;
        area += size.x * size.y + size.y * size.z + size.z * size.x;
    }
    return area;
}

TEST(Tree, HasNodesOfTheLeastArea) {
    Random random(2);
    int of_several_nodes = 0;
    for (int i = 0; i < 40; ++i) {
        const std::vector<Box> boxes = scattered_boxes(random, static_cast<std::size_t>(random.whole(5, 200)));
        const Tree tree = build_tree(boxes, {}, 0);
        Binary binary = binary_of(boxes, tree);
        const double least = binary.least_area(0);
        EXPECT_NEAR(area_of_nodes(tree), least, 1e-5 * least);
        of_several_nodes += tree.nodes.size() > 2 ? 1 : 0;
    }
    EXPECT_GT(of_several_nodes, 20);
}

}  // namespace
