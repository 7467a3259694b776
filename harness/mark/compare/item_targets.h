// The known values of the items during judging: the key's values, some of them replaced by the student's.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/mark/compare/closeness.h"
#include "reference/stages/scene_answers.h"

namespace harness {

namespace item = reference::item;

using reference::ItemId;

class ItemTargets {
  public:
    void set(const ItemId& id, Target target) { targets_[id] = std::move(target); }
    const std::map<ItemId, Target>& targets() const { return targets_; }
    /// The target of a scalar item; null if the item is unknown or has no value.
    const Target* number(const ItemId& id) const { return find(id, 1); }

    /// The item's value in its shape; empty if it has no value (the ray misses) or the scene does not ask for it.
    std::optional<Interval> scalar(const ItemId& id) const;
    std::optional<reference::Vec3<Interval>> vector(const ItemId& id) const;
    std::optional<reference::Mat3<Interval>> matrix3(const ItemId& id) const;
    std::optional<reference::Mat4<Interval>> matrix4(const ItemId& id) const;

  private:
    const Target* find(const ItemId& id, std::size_t components) const;
    std::map<ItemId, Target> targets_;
};

bool is_finite(const PrintedValue& value);

/// Whether all of its numbers are nan. A program prints nan if it takes the root of a negative discriminant.
bool is_nan(const PrintedValue& value);

/// A readable printed value as a target that can replace the key's: the enclosure of its digits, widened by the float
/// error of a stage that computes with it.
Target printed_target(const MatchedItem& printed, Digits digits);

Target target_of(const Interval& x);
Target target_of(const reference::Vec3<Interval>& p);
Target target_of(const reference::Mat3<Interval>& M);
Target target_of(const reference::Mat4<Interval>& M);
Target no_value();

using Targets = std::vector<Target>;
using Vec = reference::Vec3<Interval>;

/// compute(inputs...); empty if an input is missing.
template <class... Inputs>
Targets from(auto compute, const std::optional<Inputs>&... inputs) {
    if (!(inputs && ...)) return {};
    return {target_of(compute(*inputs...))};
}

/// The key's answer as a target: its enclosure, or no value.
Target target_of(const reference::Answer& answer);

}  // namespace harness
