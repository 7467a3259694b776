// Gathers printed rows into the matrices, and numbers below one another into the matrices and vectors, that a question
// asks for, and divides augmented matrices. Only layout and labels decide; no number is looked at.
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
    std::size_t part = 0;                     ///< index of the run of its question's values that it stands in
    std::size_t first = 0;                    ///< index in its part of the first printed value that it is made of
    std::size_t count = 1;                    ///< how many printed values it is made of
    int parts = 1;                            ///< how many candidates its printed value was taken apart into
};

/// The rows of the matrices that `items` ask for, 4 before 3.
std::vector<std::size_t> matrix_sizes(std::span<const reference::ItemSpec> items);

/// The values in printing order, with those joined that are one answer of `items`.
std::vector<Candidate> gather_rows(const std::vector<PrintedValue>& values, std::span<const reference::ItemSpec> items);

}  // namespace harness
