// An item of the assignment and its printed value.
#pragma once

#include <optional>
#include <string>

#include "harness/match/row_label.h"
#include "harness/read/first_object.h"
#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

struct MatchedItem {
    reference::ItemSpec spec;
    /// The item's printed value; empty if there is none. Its numbers have the item's shape: 1 for a scalar, 3 or 4
    /// (with w) for a vector, 9 or 16 for a matrix in the order of `order`; none for a word such as "none".
    std::optional<PrintedValue> value{};
    MatrixOrder order = MatrixOrder::unsaid;           ///< of a matrix; unsaid if the output does not say
    std::optional<PrintedFirstObject> first_object{};  ///< for the question about the first hit
    /// `value` is not an answer: it has another shape, or its line gives several values.
    bool unreadable = false;
    int several_line = 0;        ///< the line of the output with other values than `value`; 0 if there is none
    int again_line = 0;          ///< the line where its question is printed again, with as many values; 0 if it is not
    std::string place_note{};    ///< of the ItemPlace it was read from; empty if it has none
    bool by_experiment = false;  ///< that place was found on other scenes
    bool by_order = false;       ///< no words name it: it was found by its shape and order
};

}  // namespace harness
