// Finds all numbers on a line of output, whether or not they are values.
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// A minus sign before a number that is not part of the number as read.
enum class MinusBefore {
    none,
    apart,  ///< "- 6.7": its sign, or a dash after a label
    glued,  ///< "-'6.7'": its sign
};

struct NumberOfLine {
    PrintedNumber number;
    MinusBefore minus = MinusBefore::none;
    std::size_t begin = 0;  ///< byte offset in the line
    std::size_t end = 0;
    bool is_behind_equals = false;  ///< "=" or ":" is directly before it
};

/// Returns the numbers of a line of clean text, in order, without indices such as the 0 in "[0] = 1". `number` is the
/// line's number in the output.
std::vector<NumberOfLine> numbers_of_line(std::string_view line, int number);

}  // namespace harness
