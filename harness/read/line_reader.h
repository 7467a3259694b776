// The values on one line of output, with their labels.
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

struct LineReading {
    std::vector<PrintedValue> values;
    bool has_words = false;  ///< the line contains a word other than a type name
};

/// Reads the values of a line of clean text. Numbers in prose or in a formula are not values: in "5/3 = 1.66667" the
/// value is 1.66667, in "b*b - 4*a*c = 8" it is 8, in "0 <= u" there is none. In a chain such as "P_s = S + tV = (0, 0,
/// 1) + 2 * (1, 0, 0) = (2, 0, 1)" the last one is the value.
LineReading read_line(std::string_view line);

}  // namespace harness
