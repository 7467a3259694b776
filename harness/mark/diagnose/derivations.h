// Derives each item from earlier items by the stages of the reference. Follow-through uses these derivations.
#pragma once

#include <span>

#include "harness/mark/diagnose/rules.h"

namespace harness {

std::span<const Derivation> all_derivations();

/// The items that rounding may decide in a correct program (see close_call.h).
std::span<const ItemId> close_call_items();

/// Whether the item can follow from earlier answers. Z_vcs can't, because it is computed from the assignment's numbers
/// alone.
bool can_follow(const ItemId& item);

}  // namespace harness
