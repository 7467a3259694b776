// One line of a program's output, and one value with the words around it.
#pragma once

#include <string>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// Reports show at most this many bytes of a printed value.
constexpr std::size_t longest_printed = 200;

struct PrintedLine {
    std::string text;
    int number;  ///< 1-based, in the program's output
    std::vector<NumberOfLine> numbers{};
};

/// One thing that a student may have meant as an answer.
struct PrintedValue {
    std::vector<PrintedNumber> numbers;  ///< in the order printed; empty for a word such as "none" or "no hit"
    int groups = 1;                      ///< inner brackets or rows, each of numbers.size() / groups numbers
    int bar_after = 0;                   ///< in an augmented row [A | b]: how many numbers come before the bar; else 0
    bool framed = false;                 ///< printed between brackets or bars
    bool typed = false;                  ///< printed with a GLM type name, as glm::to_string does
    std::string label;                   ///< the words before it on its line; empty when there are none
    std::string after;                   ///< the words after it, up to the next value; only if no words come before it
    std::string above;                   ///< the line of words above it; only for the first value under that line
    bool above_is_title = false;         ///< `above` is the rest of a heading
    std::string printed;                 ///< as printed, one line, at most 200 bytes
    int line = 0;                        ///< 1-based, in the program's output
    int last_line = 0;                   ///< the line of its last number
};

/// A section with more values keeps only the first half and the last half of this number.
constexpr std::size_t most_values_in_section = 4000;

}  // namespace harness
