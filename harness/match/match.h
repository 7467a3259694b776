// Finds which printed value answers which item. Label, type, order and question decide together. Whether a value is
// right plays no role: the matcher sees the items, not the key.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "harness/match/label.h"
#include "harness/read/transcript.h"
#include "harness/read/verdict.h"
#include "reference/stages/items.h"

namespace harness {

struct MatchedItem {
    reference::ItemSpec spec;
    /// What was printed for it; empty when nothing was. Its numbers have the item's shape: 1 for a scalar, 3 or 4 (with
    /// w) for a vector, 9 or 16 for a matrix in the order of `order`; none for a word such as "none".
    std::optional<PrintedValue> value;
    MatrixOrder order = MatrixOrder::unsaid;  ///< of a matrix; unsaid when the printout does not tell
    std::optional<PrintedVerdict> verdict;    ///< for question 10
    /// The item's label stands before a value of another shape; `value` holds that value.
    bool unreadable = false;
};

/// Matches every item with at most one value and every value with at most one item, so that the sum of the fits is
/// largest. `items` in the handout's order; the result has the same length and order. Linear in the number of values.
std::vector<MatchedItem> match(const Transcript& transcript, std::span<const reference::ItemSpec> items);

}  // namespace harness
