// All numbers of a line of output, whatever they are.
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// A minus sign before a number that was not read with it.
enum class MinusBefore {
    none,
    apart,  ///< "- 6.7": its sign, or a dash behind a label
    glued,  ///< "-'6.7'": its sign
};

struct NumberOfLine {
    PrintedNumber number;
    MinusBefore minus = MinusBefore::none;
    std::size_t begin = 0;  ///< byte offset in the line
    std::size_t end = 0;
    bool is_behind_equals = false;  ///< "=" or ":" stands directly before it
};

/// The numbers of a line of clean text, in order, without indices such as the 0 of "[0] = 1". `number` is the line's,
/// in the output.
std::vector<NumberOfLine> numbers_of_line(std::string_view line, int number);

}  // namespace harness
