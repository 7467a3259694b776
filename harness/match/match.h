// Decides which printed value answers which item, by label, type, order and question together. It does not matter
// whether a value is right: the matcher sees the items, not the key.
#pragma once

#include <span>
#include <vector>

#include "harness/match/item_place.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// Matches every item with at most one value and every value with at most one item, so that the sum of the fits is
/// largest. `items` in the handout's order; the result has the same length and order. Linear in the number of values.
/// An item that has a place is read from there, before the others, and its value answers no other item.
std::vector<MatchedItem> match(const Transcript& transcript, std::span<const reference::ItemSpec> items,
                               std::span<const ItemPlace> places = {});

}  // namespace harness
