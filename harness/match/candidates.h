// Turns printed values into values of the shapes that a question asks for: gathers rows, and splits lists with several
// names. Only layout and labels decide, never the numbers.
#pragma once

#include <span>
#include <vector>

#include "harness/match/gathered_rows.h"
#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// The candidates for `items`, in printing order.
std::vector<Candidate> candidates_of(const std::vector<PrintedValue>& values,
                                     std::span<const reference::ItemSpec> items);

/// Splits `list` into scalars. Scalar k gets the name of item first + k of `items`.
std::vector<Candidate> take_apart(const Candidate& list, std::span<const reference::ItemSpec> items, std::size_t first);

}  // namespace harness
