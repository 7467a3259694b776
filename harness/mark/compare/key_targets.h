// The key's answers with their allowances.
#pragma once

#include <vector>

#include "harness/mark/compare/item_targets.h"

namespace harness {

/// A right answer to an item: its enclosure, and for each component how far a correct program may be off. The rubric
/// may widen this allowance.
Target target_with_allowance(const reference::KeyItem& item, const reference::Answer& answer,
                             const reference::Rubric& rubric);

/// A consistent set of the key's values for each pixel convention that the rubric accepts; the canonical convention
/// comes first.
std::vector<ItemTargets> keys_by_convention(const reference::AnswerKey& key, const reference::Rubric& rubric);

/// The key as correct float programs may compute it: each value is widened by its allowance in both directions.
ItemTargets widened_by_allowance(const ItemTargets& key);

}  // namespace harness
