#include "reference/render/scene/tree.h"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <utility>

#include "reference/render/scene/walk.h"

namespace reference::render {
namespace {

constexpr std::size_t most_bins = 16;
/// From this depth on, a node is cut in the middle of its objects, which limits the depth of the tree.
constexpr std::size_t deepest_by_cost = 32;

/// Objects with the box around them.
struct Part {
    std::span<BoxedObject> objects;
    Box box;
};

Part part_of(std::span<BoxedObject> objects) {
    Part part{objects, {}};
    for (const BoxedObject& object : objects) part.box.cover(object.box);
    return part;
}

/// Twice the middle of its box.
double middle_of(const BoxedObject& object, int axis) {
    return object.box.low[axis] + object.box.high[axis];
}

double leaves_for(std::size_t count) {
    return static_cast<double>((count + objects_per_leaf - 1) / objects_per_leaf);
}

/// Bins of equal width along each axis for the middles of objects: the fewer objects, the fewer bins.
class Bins {
  public:
    explicit Bins(std::span<const BoxedObject> objects) : count_(std::min(most_bins, 4 + objects.size() / 16)) {
        for (const BoxedObject& object : objects) {
            const Vec3<double> middle(middle_of(object, 0), middle_of(object, 1), middle_of(object, 2));
            middles_.cover({middle, middle});
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double width = middles_.high[axis] - middles_.low[axis];
            per_width_[axis] = width > 0 ? static_cast<double>(count_) * (1 - 0x1p-40) / width : 0;
            bins_[static_cast<std::size_t>(axis)].resize(count_);
        }
        for (const BoxedObject& object : objects) {
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = bins_[static_cast<std::size_t>(axis)][bin_of(object, axis)];
                bin.box.cover(object.box);
                ++bin.count;
            }
        }
    }

    std::size_t bin_of(const BoxedObject& object, int axis) const {
        const double place = (middle_of(object, axis) - middles_.low[axis]) * per_width_[axis];
        return std::min(count_ - 1, static_cast<std::size_t>(place));
    }

    /// Objects whose bin along the axis is at most `bin` go to one side.
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
        const auto& bins = bins_[static_cast<std::size_t>(axis)];
        std::array<double, most_bins> cost_of_right;
        Bin right;
        for (std::size_t bin = count_ - 1; bin > 0; --bin) {
            right.add(bins[bin]);
            cost_of_right[bin - 1] = right.count == 0 ? HUGE_VAL : right.cost();
        }
        Bin left;
        for (std::size_t bin = 0; bin + 1 < count_; ++bin) {
            left.add(bins[bin]);
            if (left.count == 0) continue;
            const double cost = left.cost() + cost_of_right[bin];
            if (cost < best.cost) best = {cost, axis, bin};
        }
    }

    std::size_t count_;
    Box middles_;
    Vec3<double> per_width_;
    std::array<boost::container::static_vector<Bin, most_bins>, 3> bins_;
};

/// Moves the objects that go left to the front and returns their number.
std::size_t split(std::span<BoxedObject> objects, std::size_t depth) {
    const Bins bins(objects);
    if (depth < deepest_by_cost) {
        const Bins::Cut cut = bins.cheapest_cut();
        if (cut.cost < HUGE_VAL) {
            const auto goes_left = [&](const BoxedObject& object) { return bins.bin_of(object, cut.axis) <= cut.bin; };
            return static_cast<std::size_t>(std::partition(objects.begin(), objects.end(), goes_left) -
                                            objects.begin());
        }
    }
    const int axis = bins.widest_axis();
    const auto key = [&](const BoxedObject& object) { return std::pair(middle_of(object, axis), object.object); };
    const auto middle = objects.begin() + static_cast<std::ptrdiff_t>(objects.size() / 2);
    std::nth_element(objects.begin(), middle, objects.end(),
                     [&](const BoxedObject& one, const BoxedObject& other) { return key(one) < key(other); });
    return objects.size() / 2;
}

using Children = boost::container::static_vector<Part, children_per_node>;

/// Cuts the part with the largest box in two, until there are enough children or each is a leaf.
Children children_of(const Part& whole, std::size_t depth) {
    Children parts{whole};
    while (parts.size() < children_per_node) {
        Part* widest = nullptr;
        for (Part& part : parts) {
            if (part.objects.size() <= objects_per_leaf) continue;
            if (widest == nullptr || part.box.half_area() > widest->box.half_area()) widest = &part;
        }
        if (widest == nullptr) break;
        const std::span<BoxedObject> objects = widest->objects;
        const std::size_t left = split(objects, depth);
        *widest = part_of(objects.first(left));
        parts.push_back(part_of(objects.subspan(left)));
    }
    return parts;
}

class Builder {
  public:
    Builder(Tree& tree, std::span<const kernel::PreparedTriangle<double>> triangles, std::uint32_t first_triangle)
        : tree_(tree), triangles_(triangles), first_triangle_(first_triangle) {}

    void build(const Part& whole) {
        add_node(whole, 0);
        tree_.leaves.reserve(leaves_.size());
        for (const std::span<const BoxedObject> objects : leaves_) add_leaf(objects);
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

    void add_node(const Part& whole, std::size_t depth) {
        const std::size_t here = tree_.nodes.size();
        tree_.nodes.push_back(empty_node());
        const Children children = children_of(whole, depth);
        for (std::size_t i = 0; i < children.size(); ++i) {
            set_sides(tree_.nodes[here], i, children[i].box);
            if (children[i].objects.size() <= objects_per_leaf) {
                tree_.nodes[here].children[i] = first_leaf + static_cast<std::uint32_t>(leaves_.size());
                leaves_.push_back(children[i].objects);
            } else {
                tree_.nodes[here].children[i] = static_cast<std::uint32_t>(tree_.nodes.size());
                add_node(children[i], depth + 1);
            }
        }
    }

    void set_sides(Node& node, std::size_t child, const Box& box) const {
        for (int axis = 0; axis < 3; ++axis) {
            const auto in_tree = [&](double x) { return static_cast<float>((x - tree_.center[axis]) * tree_.scale); };
            node.sides[2 * static_cast<std::size_t>(axis)][child] = in_tree(box.low[axis]);
            node.sides[2 * static_cast<std::size_t>(axis) + 1][child] = in_tree(box.high[axis]);
        }
    }

    void add_leaf(std::span<const BoxedObject> objects) {
        Leaf& leaf = tree_.leaves.emplace_back();
        leaf.count = static_cast<std::uint32_t>(objects.size());
        for (std::size_t lane = 0; lane < objects_per_leaf; ++lane) {
            const std::uint32_t object = objects[lane < objects.size() ? lane : 0].object;
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
    std::span<const kernel::PreparedTriangle<double>> triangles_;
    std::uint32_t first_triangle_;
    std::vector<std::span<const BoxedObject>> leaves_;
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

Tree build_tree(InHugePages<BoxedObject> objects, std::span<const kernel::PreparedTriangle<double>> triangles,
                std::uint32_t first_triangle) {
    const Part whole = part_of(objects);
    Tree tree{};
    tree.instructions = best_instructions();
    set_coordinates(tree, whole.box);
    Builder(tree, triangles, first_triangle).build(whole);
    return tree;
}

}  // namespace reference::render
