// From the values as printed to values of the shapes a question asks for: rows gathered into matrices, augmented matrices
// divided, lists with several names taken apart. Layout and labels decide; no number is looked at.
#pragma once

#include <span>
#include <vector>

#include "harness/label.h"
#include "harness/transcript.h"
#include "reference/items.h"

namespace harness {

/// A printed value that may answer an item.
struct Candidate {
    PrintedValue value;
    MatrixOrder order = MatrixOrder::unsaid;  ///< of a matrix
};

/// The candidates for `items`, in printing order.
std::vector<Candidate> arrange(const std::vector<PrintedValue>& values, std::span<const reference::ItemSpec> items);

/// The list `value` taken apart into scalars, named in turn by items [first, first + count) of `items`.
std::vector<Candidate> take_apart(const PrintedValue& value, std::span<const reference::ItemSpec> items, std::size_t first);

}  // namespace harness
