// Gathers printed rows into matrices, and numbers printed below one another into matrices and vectors, as a question
// asks for them, and divides augmented matrices. Only layout and labels decide, never the numbers.
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

/// The row counts of the matrices among `items`, 4 before 3.
std::vector<std::size_t> matrix_sizes(std::span<const reference::ItemSpec> items);

/// The values in printing order. Values that form one answer of `items` are joined.
std::vector<Candidate> gather_rows(const std::vector<PrintedValue>& values, std::span<const reference::ItemSpec> items);

}  // namespace harness
