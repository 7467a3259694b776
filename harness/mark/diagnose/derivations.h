// How each item follows from earlier items by the stages of the reference. Follow-through is based on this.
#pragma once

#include <span>

#include "harness/mark/diagnose/rules.h"

namespace harness {

std::span<const Derivation> all_derivations();

/// The items that rounding may decide in a correct program (see close_call.h).
std::span<const ItemId> close_call_items();

/// Whether the item can follow from earlier answers, and is not computed from the assignment's numbers alone, as Z_vcs
/// is.
bool can_follow(const ItemId& item);

}  // namespace harness
