// Turns printed values into values of the shapes that a question asks for: gathers rows, and splits lists with several
// names. Only layout and labels decide, never the numbers.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "harness/match/row_label.h"
#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// A printed value that may answer an item.
struct Candidate {
    PrintedValue value;
    MatrixOrder order = MatrixOrder::unsaid;  ///< of a matrix
    std::size_t part = 0;                     ///< index of its run among the runs of its question's values
    std::size_t first = 0;                    ///< index in its part of the first printed value it consists of
    std::size_t count = 1;                    ///< how many printed values it consists of
    int parts = 1;                            ///< how many candidates its printed value was split into
};

/// The candidates for `items`, in printing order.
std::vector<Candidate> candidates_of(const std::vector<PrintedValue>& values,
                                     std::span<const reference::ItemSpec> items);

/// Splits `list` into scalars. Scalar k gets the name of item first + k of `items`.
std::vector<Candidate> take_apart(const Candidate& list, std::span<const reference::ItemSpec> items, std::size_t first);

}  // namespace harness
