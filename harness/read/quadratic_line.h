// A quadratic equation with its coefficients put in.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

struct QuadraticLine {
    std::vector<PrintedValue> values;  ///< labeled a, b and c
    std::size_t end;                   ///< of the equation in the line, a byte offset
};

/// Reads "1 t^2 + (-4) t + 2 = 0" and "t^2 - 6.7t + 10.2 = 0", wherever it begins in the line; empty for any other
/// line.
std::optional<QuadraticLine> read_quadratic(std::string_view line);

}  // namespace harness
