#include "reference/render/scene/tree.h"

#include <algorithm>
#include <array>

#include "reference/render/scene/walk.h"

namespace reference::render {
namespace {

constexpr std::size_t bin_count = 16;
/// From this depth on, a node is cut in the middle of its objects, which limits the depth of the tree.
constexpr std::size_t deepest_by_cost = 32;

struct Item {
    Box box;
    std::uint32_t object;

    /// Twice the middle of its box.
    double middle(int axis) const { return box.low[axis] + box.high[axis]; }
};

/// Items with the box around them.
struct Part {
    std::span<Item> items;
    Box box;
};

Part part_of(std::span<Item> items) {
    Part part{items, {}};
    for (const Item& item : items) part.box.cover(item.box);
    return part;
}

double leaves_for(std::size_t count) {
    return static_cast<double>((count + objects_per_leaf - 1) / objects_per_leaf);
}

/// Bins of equal width along each axis for the middles of items.
class Bins {
  public:
    explicit Bins(std::span<const Item> items) {
        for (const Item& item : items) {
            const Vec3<double> middle(item.middle(0), item.middle(1), item.middle(2));
            middles_.cover({middle, middle});
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double width = middles_.high[axis] - middles_.low[axis];
            per_width_[axis] = width > 0 ? static_cast<double>(bin_count) * (1 - 0x1p-40) / width : 0;
        }
        for (const Item& item : items) {
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = bins_[static_cast<std::size_t>(axis)][bin_of(item, axis)];
                bin.box.cover(item.box);
                ++bin.count;
            }
        }
    }

    std::size_t bin_of(const Item& item, int axis) const {
        const double place = (item.middle(axis) - middles_.low[axis]) * per_width_[axis];
        return std::min(bin_count - 1, static_cast<std::size_t>(place));
    }

    /// Items whose bin along the axis is at most `bin` go to one side.
    struct Cut {
        double cost = HUGE_VAL;  ///< infinite where all go to one side
        int axis = 0;
        std::size_t bin = 0;
    };

    /// The cut after which a ray is expected to try the fewest leaves: the surface area heuristic of MacDonald and
    /// Booth (1990).
    Cut cheapest_cut() const {
        Cut best;
        for (int axis = 0; axis < 3; ++axis) improve(best, axis);
        return best;
    }

    int widest_axis() const {
        const Vec3<double> size = middles_.high - middles_.low;
        if (size.x >= size.y && size.x >= size.z) return 0;
        return size.y >= size.z ? 1 : 2;
    }

  private:
    struct Bin {
        Box box;
        std::size_t count = 0;

        void add(const Bin& other) {
            box.cover(other.box);
            count += other.count;
        }
        double cost() const { return count == 0 ? 0 : box.half_area() * leaves_for(count); }
    };

    void improve(Cut& best, int axis) const {
        const std::array<Bin, bin_count>& bins = bins_[static_cast<std::size_t>(axis)];
        std::array<double, bin_count> cost_of_right{};
        Bin right;
        for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
            right.add(bins[bin]);
            cost_of_right[bin - 1] = right.count == 0 ? HUGE_VAL : right.cost();
        }
        Bin left;
        for (std::size_t bin = 0; bin + 1 < bin_count; ++bin) {
            left.add(bins[bin]);
            if (left.count == 0) continue;
            const double cost = left.cost() + cost_of_right[bin];
            if (cost < best.cost) best = {cost, axis, bin};
        }
    }

    Box middles_;
    Vec3<double> per_width_;
    std::array<std::array<Bin, bin_count>, 3> bins_;
};

/// Moves the items that go left to the front and returns their number.
std::size_t split(std::span<Item> items, std::size_t depth) {
    const Bins bins(items);
    if (depth < deepest_by_cost) {
        const Bins::Cut cut = bins.cheapest_cut();
        if (cut.cost < HUGE_VAL) {
            const auto goes_left = [&](const Item& item) { return bins.bin_of(item, cut.axis) <= cut.bin; };
            return static_cast<std::size_t>(std::partition(items.begin(), items.end(), goes_left) - items.begin());
        }
    }
    const int axis = bins.widest_axis();
    const auto key = [&](const Item& item) { return std::pair(item.middle(axis), item.object); };
    const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), middle, items.end(),
                     [&](const Item& one, const Item& other) { return key(one) < key(other); });
    return items.size() / 2;
}

/// Cuts the part with the largest box in two, until there are enough children or each is a leaf.
std::vector<Part> children_of(const Part& whole, std::size_t depth) {
    std::vector<Part> parts{whole};
    while (parts.size() < children_per_node) {
        Part* widest = nullptr;
        for (Part& part : parts) {
            if (part.items.size() <= objects_per_leaf) continue;
            if (widest == nullptr || part.box.half_area() > widest->box.half_area()) widest = &part;
        }
        if (widest == nullptr) break;
        const std::span<Item> items = widest->items;
        const std::size_t left = split(items, depth);
        *widest = part_of(items.first(left));
        parts.push_back(part_of(items.subspan(left)));
    }
    return parts;
}

class Builder {
  public:
    Builder(Tree& tree, std::span<const Triangle<double>> triangles, std::uint32_t first_triangle)
        : tree_(tree), triangles_(triangles), first_triangle_(first_triangle) {}

    void add_node(const Part& whole, std::size_t depth) {
        const std::size_t here = tree_.nodes.size();
        tree_.nodes.push_back(empty_node());
        const std::vector<Part> children = children_of(whole, depth);
        for (std::size_t i = 0; i < children.size(); ++i) {
            set_sides(tree_.nodes[here], i, children[i].box);
            if (children[i].items.size() <= objects_per_leaf) {
                tree_.nodes[here].children[i] = first_leaf + static_cast<std::uint32_t>(tree_.leaves.size());
                add_leaf(children[i].items);
            } else {
                tree_.nodes[here].children[i] = static_cast<std::uint32_t>(tree_.nodes.size());
                add_node(children[i], depth + 1);
            }
        }
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

    void set_sides(Node& node, std::size_t child, const Box& box) const {
        for (int axis = 0; axis < 3; ++axis) {
            const auto in_tree = [&](double x) { return static_cast<float>((x - tree_.center[axis]) * tree_.scale); };
            node.sides[2 * static_cast<std::size_t>(axis)][child] = in_tree(box.low[axis]);
            node.sides[2 * static_cast<std::size_t>(axis) + 1][child] = in_tree(box.high[axis]);
        }
    }

    void add_leaf(std::span<const Item> items) {
        Leaf& leaf = tree_.leaves.emplace_back();
        leaf.count = static_cast<std::uint32_t>(items.size());
        for (std::size_t lane = 0; lane < objects_per_leaf; ++lane) {
            const std::uint32_t object = items[lane < items.size() ? lane : 0].object;
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
        if (number < triangles_.size()) return triangles_[number];
        const Vec3<double> unknown(NAN, NAN, NAN);
        return {unknown, unknown, unknown};
    }

    Tree& tree_;
    std::span<const Triangle<double>> triangles_;
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

void Box::cover(const Box& other) {
    for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], other.low[i]);
        high[i] = std::max(high[i], other.high[i]);
    }
}

double Box::half_area() const {
    const Vec3<double> size = high - low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
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

Tree build_tree(std::span<const Box> boxes, std::span<const Triangle<double>> triangles, std::uint32_t first_triangle) {
    std::vector<Item> items;
    items.reserve(boxes.size());
    for (const Box& box : boxes) items.push_back({box, static_cast<std::uint32_t>(items.size())});
    const Part whole = part_of(items);
    Tree tree{};
    tree.instructions = best_instructions();
    set_coordinates(tree, whole.box);
    Builder(tree, triangles, first_triangle).add_node(whole, 0);
    return tree;
}

}  // namespace reference::render
