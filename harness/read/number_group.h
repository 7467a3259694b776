// Numbers that stand together on a line of output: a vector, the coefficients of a quadratic, a matrix.
#pragma once

#include <optional>
#include <vector>

#include "harness/line_tokens.h"

namespace harness {

struct NumberGroup {
    std::vector<PrintedNumber> numbers;  ///< at least one
    int groups = 1;                      ///< rows or columns of equal size, in brackets or divided by semicolons
    int bar_after = 0;                   ///< the numbers before a '|', as in "0 2 -2 | 0"; 0 without
    std::size_t first;                   ///< its tokens are [first, last)
    std::size_t last;
};

/// The number at `begin` and those that follow in a row without words between: "1 -4 2", "0, 0, -2", "0 2 -2 | 0".
/// Empty where it is a term of a formula or an index.
std::optional<NumberGroup> read_row(const LineTokens& tokens, std::size_t begin);

/// "(0, 0, -2)" or "((1, 0), (0, 1))": a bracket that holds numbers only.
std::optional<NumberGroup> read_bracket(const LineTokens& tokens, std::size_t begin);

/// "row 1", "column 0": the number is part of the label.
bool is_index(const LineTokens& tokens, std::size_t i);

}  // namespace harness
