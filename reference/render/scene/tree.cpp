#include "reference/render/scene/tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace reference::render {
namespace {

constexpr std::size_t objects_per_leaf = 4;
constexpr std::size_t bin_count = 16;
/// From this depth on, a node is cut in the middle of its objects, which limits the depth of the tree.
constexpr std::size_t deepest_by_cost = 32;

struct Item {
    Box box;
    Vec3<double> middle;
    std::uint32_t object;
};

using Items = std::span<Item>;

Box box_around(Items items) {
    Box box;
    for (const Item& item : items) box.cover(item.box);
    return box;
}

Box box_around_middles(Items items) {
    Box box;
    for (const Item& item : items) box.cover({item.middle, item.middle});
    return box;
}

/// The index of the bin along an axis that the item's middle falls into.
std::size_t bin_of(const Item& item, const Box& middles, int axis) {
    const double width = middles.high[axis] - middles.low[axis];
    const double place = (item.middle[axis] - middles.low[axis]) / width * static_cast<double>(bin_count);
    return std::min(bin_count - 1, static_cast<std::size_t>(std::max(place, 0.0)));
}

/// Where to cut between bins so that a ray is expected to try the fewest objects (the surface area heuristic of
/// MacDonald and Booth, 1990): bins up to `bin` go left.
struct Cut {
    double cost;
    std::size_t bin;
};

Cut cheapest_cut(Items items, const Box& middles, int axis) {
    std::array<Box, bin_count> boxes;
    std::array<std::size_t, bin_count> counts{};
    for (const Item& item : items) {
        const std::size_t bin = bin_of(item, middles, axis);
        boxes[bin].cover(item.box);
        ++counts[bin];
    }
    std::array<double, bin_count> cost_of_right{};
    Box right;
    std::size_t right_count = 0;
    for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
        right.cover(boxes[bin]);
        right_count += counts[bin];
        cost_of_right[bin - 1] = right_count == 0 ? 0 : right.half_area() * static_cast<double>(right_count);
    }
    Cut best{HUGE_VAL, 0};
    Box left;
    std::size_t left_count = 0;
    for (std::size_t bin = 0; bin + 1 < bin_count; ++bin) {
        left.cover(boxes[bin]);
        left_count += counts[bin];
        if (left_count == 0 || left_count == items.size()) continue;
        const double cost = left.half_area() * static_cast<double>(left_count) + cost_of_right[bin];
        if (cost < best.cost) best = {cost, bin};
    }
    return best;
}

int widest_axis(const Box& box) {
    const Vec3<double> size = box.high - box.low;
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

/// Moves the items that go left to the front and returns their number.
std::size_t split(Items items, int axis, std::size_t depth) {
    const Box middles = box_around_middles(items);
    if (depth < deepest_by_cost && middles.high[axis] > middles.low[axis]) {
        const Cut cut = cheapest_cut(items, middles, axis);
        const auto goes_left = [&](const Item& item) { return bin_of(item, middles, axis) <= cut.bin; };
        const auto middle = std::stable_partition(items.begin(), items.end(), goes_left);
        const auto count = static_cast<std::size_t>(middle - items.begin());
        if (count > 0 && count < items.size()) return count;
    }
    std::stable_sort(items.begin(), items.end(),
                     [&](const Item& one, const Item& other) { return one.middle[axis] < other.middle[axis]; });
    return items.size() / 2;
}

void add_nodes(Items items, std::size_t depth, Tree& tree) {
    const std::size_t here = tree.nodes.size();
    const auto next_object = static_cast<std::uint32_t>(tree.objects.size());
    tree.nodes.push_back({box_around(items), next_object, static_cast<std::uint32_t>(items.size()), 0});
    if (items.size() <= objects_per_leaf) {
        for (const Item& item : items) tree.objects.push_back(item.object);
        return;
    }
    const int axis = widest_axis(box_around_middles(items));
    const std::size_t left = split(items, axis, depth);
    add_nodes(items.first(left), depth + 1, tree);
    tree.nodes[here].first = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes[here].count = 0;
    tree.nodes[here].axis = static_cast<std::uint32_t>(axis);
    add_nodes(items.subspan(left), depth + 1, tree);
}

}  // namespace

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

Tree build_tree(std::span<const Box> boxes) {
    std::vector<Item> items;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box& box = boxes[i];
        items.push_back({box, scaled(Vec3<double>(box.low + box.high), 0.5), static_cast<std::uint32_t>(i)});
    }
    Tree tree;
    add_nodes(items, 0, tree);
    return tree;
}

}  // namespace reference::render
