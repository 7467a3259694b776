// The sentence of question 10: "ray hits triangle first", in the words students use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/stages/first_hit.h"

namespace harness {

struct PrintedVerdict {
    reference::Verdict verdict;
    std::string printed;  ///< the line, at most 200 bytes
    std::size_t line;     ///< index into the lines given
};

/// The verdict that the lines state; where several do, the last. A line about one object's t is none.
std::optional<PrintedVerdict> read_verdict(const std::vector<std::string>& lines);

}  // namespace harness
