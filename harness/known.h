// What is known of the items while one of them is judged: the key's values, with some replaced by what the student
// printed.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "harness/closeness.h"
#include "reference/pipeline.h"

namespace harness {

using reference::ItemId;

class Known {
  public:
    void set(const ItemId& id, Target target) { targets_[id] = std::move(target); }
    const std::map<ItemId, Target>& targets() const { return targets_; }
    /// Null when nothing is known of the item, or that it has no value.
    const Target* number(const ItemId& id) const { return find(id, 1); }

    /// The item's value in its shape; empty when it has none (the ray misses) or the scene does not ask for it.
    std::optional<Real> scalar(const ItemId& id) const;
    std::optional<reference::Vec3<Real>> vector(const ItemId& id) const;
    std::optional<reference::Mat3<Real>> matrix3(const ItemId& id) const;
    std::optional<reference::Mat4<Real>> matrix4(const ItemId& id) const;

  private:
    const Target* find(const ItemId& id, std::size_t components) const;
    std::map<ItemId, Target> targets_;
};

/// A readable printed value as a target, so that it can stand in for the key's: what its digits say, widened by what
/// float arithmetic adds when a stage computes with it.
Target printed_target(const MatchedItem& printed, Digits digits);

Target target_of(const Real& x);
Target target_of(const reference::Vec3<Real>& p);
Target target_of(const reference::Mat3<Real>& M);
Target target_of(const reference::Mat4<Real>& M);
Target no_value();

/// The key's answer: its enclosure where it has one.
Target target_of(const reference::Answer& answer);

}  // namespace harness
