// Numbers printed together on a line of output: a vector, the coefficients of a quadratic, a matrix.
#pragma once

#include <optional>
#include <vector>

#include "harness/read/tokens/line_tokens.h"

namespace harness {

struct NumberGroup {
    std::vector<PrintedNumber> numbers;  ///< at least one
    int groups = 1;                      ///< rows or columns of equal size, in brackets or divided by semicolons
    int bar_after = 0;                   ///< how many numbers come before a '|': 3 in "0 2 -2 | 0"; 0 without a bar
    std::size_t first;                   ///< the group's tokens are [first, last)
    std::size_t last;
};

/// Reads the number at `begin` and the numbers after it up to the next word: "1 -4 2", "0, 0, -2", "0 2 -2 | 0". Empty
/// if the number is a term of a formula or an index.
std::optional<NumberGroup> read_row(const LineTokens& tokens, std::size_t begin);

/// Reads a bracket that contains only numbers: "(0, 0, -2)" or "((1, 0), (0, 1))".
std::optional<NumberGroup> read_bracket(const LineTokens& tokens, std::size_t begin);

/// Whether number i is part of a label: "row 1", "column 0".
bool is_index(const LineTokens& tokens, std::size_t i);

}  // namespace harness
