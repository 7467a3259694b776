// Reads a quadratic equation that is printed with its coefficients.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

struct QuadraticLine {
    std::vector<PrintedValue> values;  ///< labeled a, b and c
    std::size_t end;                   ///< byte offset of the equation's end in the line
};

/// Reads "1 t^2 + (-4) t + 2 = 0" and "t^2 - 6.7t + 10.2 = 0", wherever it begins in the line. Empty for any other
/// line.
std::optional<QuadraticLine> read_quadratic(std::string_view line);

}  // namespace harness
