// The key's answers with what they forgive.
#pragma once

#include <vector>

#include "harness/known.h"

namespace harness {

/// One right answer to an item: its enclosure, and for each component how far a correct program may be off, or more
/// where the rubric widens it.
Target target_with_allowance(const reference::KeyItem& item, const reference::Answer& answer,
                             const reference::Rubric& rubric);

/// The key's values that belong together, once for each pixel convention that the rubric accepts, the canonical one
/// first.
std::vector<Known> keys_by_convention(const reference::AnswerKey& key, const reference::Rubric& rubric);

/// The same as right float programs know it: each value with its allowance either way.
Known widened_by_allowance(const Known& key);

}  // namespace harness
