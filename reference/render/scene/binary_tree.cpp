#include "reference/render/scene/binary_tree.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <utility>

namespace reference::render {
namespace {

constexpr std::size_t most_bins = 16;

using AxisInts [[gnu::vector_size(16)]] = std::int32_t;

AxisFloats on_all_axes(float x) {
    return AxisFloats{x, x, x, 0};
}

/// Twice the middle.
AxisFloats middle_of(const FloatBox& box) {
    return box.low + box.high;
}

/// Objects, with the box around them and the box around their middles.
struct Part {
    std::span<BoxedObject> objects;
    FloatBox box;
    FloatBox middles;

    void cover(const FloatBox& object) {
        const AxisFloats middle = middle_of(object);
        box.cover(object);
        middles.cover({middle, middle});
    }
};

Part part_of(std::span<BoxedObject> objects) {
    Part part{objects, {}, {}};
    for (const BoxedObject& object : objects) part.cover(object.box());
    return part;
}

struct Halves {
    Part one;
    Part other;
};

/// Bins of equal width along each axis for the middles of objects: the fewer objects, the fewer bins.
class Bins {
  public:
    Bins(const Part& part, std::size_t most_in_leaf)
        : count_(std::min(most_bins, 8 + part.objects.size() / 16)),
          most_in_leaf_(most_in_leaf),
          low_(part.middles.low) {
        const AxisFloats width = part.middles.high - part.middles.low;
        // So much less than the number of bins that no rounding reaches it.
        const AxisFloats all = on_all_axes(static_cast<float>(count_) * (1 - 0x1p-20F));
        per_width_ = width > on_all_axes(0x1p-60F) ? all / width : AxisFloats{};
        for (auto& bins : bins_) bins.resize(count_);
        for (const BoxedObject& object : part.objects) {
            const FloatBox box = object.box();
            const AxisInts bin = bin_of(box);
            add(bins_[0][static_cast<std::size_t>(bin[0])], box);
            add(bins_[1][static_cast<std::size_t>(bin[1])], box);
            add(bins_[2][static_cast<std::size_t>(bin[2])], box);
        }
    }

    AxisInts bin_of(const FloatBox& box) const {
        return __builtin_convertvector((middle_of(box) - low_) * per_width_, AxisInts);
    }

    /// Objects whose bin along the axis is at most `bin` go to one side.
    struct Cut {
        float cost = HUGE_VALF;  ///< infinite where all go to one side
        std::size_t axis = 0;
        std::int32_t bin = 0;
    };

    /// The cut after which a ray is expected to try the fewest leaves.
    Cut cheapest_cut() const {
        Cut best;
        for (std::size_t axis = 0; axis < 3; ++axis) improve(best, axis);
        return best;
    }

  private:
    struct Bin {
        FloatBox box;
        std::size_t count = 0;

        void add(const Bin& other) {
            box.cover(other.box);
            count += other.count;
        }
    };

    static void add(Bin& bin, const FloatBox& box) {
        bin.box.cover(box);
        ++bin.count;
    }

    float cost(const Bin& bin) const {
        const std::size_t leaves = (bin.count + most_in_leaf_ - 1) / most_in_leaf_;
        return bin.box.half_area() * static_cast<float>(leaves);
    }

    void improve(Cut& best, std::size_t axis) const {
        const auto& bins = bins_[axis];
        std::array<float, most_bins> cost_of_right;
        Bin right;
        for (std::size_t bin = count_ - 1; bin > 0; --bin) {
            right.add(bins[bin]);
            cost_of_right[bin - 1] = right.count == 0 ? HUGE_VALF : cost(right);
        }
        Bin left;
        for (std::size_t bin = 0; bin + 1 < count_; ++bin) {
            left.add(bins[bin]);
            if (left.count == 0) continue;
            const float both = cost(left) + cost_of_right[bin];
            if (both < best.cost) best = {both, axis, static_cast<std::int32_t>(bin)};
        }
    }

    std::size_t count_;
    std::size_t most_in_leaf_;
    AxisFloats low_;
    AxisFloats per_width_;
    std::array<boost::container::static_vector<Bin, most_bins>, 3> bins_;
};

Halves cut_at(const Part& whole, const Bins& bins, const Bins::Cut& cut) {
    Halves halves;
    BoxedObject* left = whole.objects.data();
    BoxedObject* right = left + whole.objects.size();
    const auto goes_left = [&](const FloatBox& box) { return bins.bin_of(box)[cut.axis] <= cut.bin; };
    while (left != right) {
        const FloatBox box = left->box();
        if (goes_left(box)) {
            halves.one.cover(box);
            ++left;
        } else {
            halves.other.cover(box);
            std::swap(*left, *--right);
        }
    }
    const auto count = static_cast<std::size_t>(left - whole.objects.data());
    halves.one.objects = whole.objects.first(count);
    halves.other.objects = whole.objects.subspan(count);
    return halves;
}

Halves cut_in_the_middle(const Part& whole) {
    const AxisFloats size = whole.middles.high - whole.middles.low;
    const std::array<float, 3> sizes{size[0], size[1], size[2]};
    const auto axis = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
    const auto key = [&](const BoxedObject& object) {
        return std::pair<float, std::uint32_t>(middle_of(object.box())[axis], object.number());
    };
    const auto middle = whole.objects.begin() + static_cast<std::ptrdiff_t>(whole.objects.size() / 2);
    std::nth_element(whole.objects.begin(), middle, whole.objects.end(),
                     [&](const BoxedObject& one, const BoxedObject& other) { return key(one) < key(other); });
    return {part_of({whole.objects.begin(), middle}), part_of({middle, whole.objects.end()})};
}

class Cutter {
  public:
    Cutter(std::span<BoxedObject> objects, std::size_t most_in_leaf, std::size_t levels_by_cost)
        : all_(objects), most_in_leaf_(most_in_leaf), levels_by_cost_(levels_by_cost) {
        nodes_.reserve(2 * objects.size() / (most_in_leaf - 1) + 1);  // which leaves are rarely emptier than
        const Part whole = part_of(objects);
        nodes_.push_back(leaf(whole));
        cut(0, whole, 0);
    }

    InHugePages<BinaryNode> nodes() { return std::move(nodes_); }

  private:
    BinaryNode leaf(const Part& part) const {
        return {part.box, static_cast<std::uint32_t>(part.objects.data() - all_.data()),
                static_cast<std::uint32_t>(part.objects.size()), 0};
    }

    void cut(std::size_t node, const Part& part, std::size_t depth) {
        if (part.objects.size() <= most_in_leaf_) return;
        const Halves halves = halves_of(part, depth);
        const std::size_t first = nodes_.size();
        nodes_[node].halves = static_cast<std::uint32_t>(first);
        nodes_.push_back(leaf(halves.one));
        nodes_.push_back(leaf(halves.other));
        cut(first, halves.one, depth + 1);
        cut(first + 1, halves.other, depth + 1);
    }

    Halves halves_of(const Part& whole, std::size_t depth) const {
        if (depth < levels_by_cost_) {
            const Bins bins(whole, most_in_leaf_);
            const Bins::Cut cut = bins.cheapest_cut();
            if (cut.cost < HUGE_VALF) return cut_at(whole, bins, cut);
        }
        return cut_in_the_middle(whole);
    }

    std::span<BoxedObject> all_;
    std::size_t most_in_leaf_;
    std::size_t levels_by_cost_;
    InHugePages<BinaryNode> nodes_;
};

}  // namespace

InHugePages<BinaryNode> binary_tree(std::span<BoxedObject> objects, std::size_t most_in_leaf,
                                    std::size_t levels_by_cost) {
    return Cutter(objects, most_in_leaf, levels_by_cost).nodes();
}

}  // namespace reference::render
