// From the values as printed to values of the shapes a question asks for: rows gathered into matrices, augmented
// matrices divided, lists with several names taken apart. Layout and labels decide; no number is looked at.
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
    std::size_t part = 0;                     ///< which of its question's runs of values it stands in
    std::size_t first = 0;                    ///< index of the first printed value that it is made of, in its part
    std::size_t count = 1;                    ///< how many printed values it is made of
    int parts = 1;                            ///< how many candidates its printed value was taken apart into
};

/// The candidates for `items`, in printing order.
std::vector<Candidate> arrange(const std::vector<PrintedValue>& values, std::span<const reference::ItemSpec> items);

/// The list `list` taken apart into scalars, named in turn by items [first, first + count) of `items`.
std::vector<Candidate> take_apart(const Candidate& list, std::span<const reference::ItemSpec> items, std::size_t first);

}  // namespace harness
