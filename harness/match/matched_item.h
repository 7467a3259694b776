// An item of the assignment and what was printed for it.
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
    /// What was printed for it; empty when nothing was. Its numbers have the item's shape: 1 for a scalar, 3 or 4 (with
    /// w) for a vector, 9 or 16 for a matrix in the order of `order`; none for a word such as "none".
    std::optional<PrintedValue> value{};
    MatrixOrder order = MatrixOrder::unsaid;           ///< of a matrix; unsaid when the printout does not tell
    std::optional<PrintedFirstObject> first_object{};  ///< for the question what is hit first
    /// `value` is no answer: it has another shape, or its line offers several values.
    bool unreadable = false;
    int several_line = 0;        ///< the line of the output that offers other values than `value`; 0 if there is none
    int again_line = 0;          ///< the line where its question is printed again, with as many values; 0 if it is not
    std::string place_note{};    ///< of the ItemPlace that it was read from; empty if it has none
    bool by_experiment = false;  ///< that place is where other scenes show it
    bool by_order = false;       ///< no words name it: it was found by its shape and its order
};

}  // namespace harness
