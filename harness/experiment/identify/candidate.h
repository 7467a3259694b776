// Numbers of an output that may be an item.
#pragma once

#include <cstddef>
#include <vector>

#include "harness/match/item_place.h"
#include "reference/stages/items.h"

namespace harness::experiment {

struct Candidate {
    std::vector<std::size_t> slots;           ///< in the order of the item's components
    MatrixOrder order = MatrixOrder::unsaid;  ///< as the output states it
    bool takes_signs = false;                 ///< a minus sign that is apart from a number's digits belongs to it

    bool is_negated(const NumberOfLine& number) const {
        return number.minus == MinusBefore::glued || (takes_signs && number.minus == MinusBefore::apart);
    }
};

/// The components of an item of this shape, and the rows of a matrix; 1 for others.
std::size_t size_of(reference::Shape shape);
std::size_t side_of(reference::Shape shape);

/// How the numbers of a block may lie among all numbers: `step` from one to the next, `row` from one row to the next.
/// Others may be between them: indices, components of a neighbor in a table.
struct Pattern {
    std::size_t step;
    std::size_t row;
};
std::vector<Pattern> all_patterns(reference::Shape shape);
/// Those that are tried for wrong answers.
std::vector<Pattern> common_patterns(reference::Shape shape);

}  // namespace harness::experiment
