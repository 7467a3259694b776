// Values printed as the parts of a formula.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

struct LinearForm {
    std::vector<PrintedValue> values;
    std::size_t end;  ///< of the formula in the line; beyond it more may be printed
};

/// Reads the values of a line that is a sum of terms; empty for any other line:
///   "1 t^2 + (-4) t + (2) = 0"      three values labelled a, b and c; words may stand before it, and ", d = 8" behind
///   "0.5 t + 2 u - 2 v = 1.5"       one row of an augmented matrix, columns t, u, v; 0 for an omitted variable
///   "0.3i + 0.4j - 0.87k"           one vector
/// Linear in the line's length. Lines longer than 1000 bytes are not read.
std::optional<LinearForm> read_linear_form(std::string_view line);

}  // namespace harness
