// Numbers of an output that may be an item.
#pragma once

#include <cstddef>
#include <vector>

#include "harness/match/item_place.h"
#include "reference/stages/items.h"

namespace harness::experiment {

struct Candidate {
    std::vector<std::size_t> slots;           ///< in the order of the item's components
    MatrixOrder order = MatrixOrder::unsaid;  ///< as stated in the output
    bool takes_signs = false;                 ///< a minus sign separate from a number's digits belongs to the number

    bool is_negated(const NumberOfLine& number) const {
        return number.minus == MinusBefore::glued || (takes_signs && number.minus == MinusBefore::apart);
    }
};

/// The number of components of an item with this shape, and the number of rows of a matrix; 1 for other shapes.
std::size_t size_of(reference::Shape shape);
std::size_t side_of(reference::Shape shape);

/// The positions of a block's numbers among all numbers: `step` from one number to the next, `row` from one row to the
/// next. Other numbers may lie between them: indices, or components of a neighbor in a table.
struct Pattern {
    std::size_t step;
    std::size_t row;
};
std::vector<Pattern> all_patterns(reference::Shape shape);
/// The patterns that are tried for wrong answers.
std::vector<Pattern> common_patterns(reference::Shape shape);

}  // namespace harness::experiment
