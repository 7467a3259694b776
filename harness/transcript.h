// What a program printed, read: sections by question, in each the values with their labels. Reading never knows the
// key.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/token.h"

namespace harness {

/// One thing that a student may have meant as an answer.
struct PrintedValue {
    std::vector<PrintedNumber> numbers;  ///< in the order printed; empty for a word such as "none" or "no hit"
    int groups = 1;                      ///< inner brackets or rows, each of numbers.size() / groups numbers
    int bar_after = 0;                   ///< in an augmented row [A | b]: how many numbers stand before the bar; else 0
    bool framed = false;                 ///< printed between brackets or bars
    bool typed = false;                  ///< printed with a GLM type name, as glm::to_string does
    std::string label;                   ///< the words before it on its line; empty when there are none
    std::string after;            ///< the words behind it, up to the next value or the line's end, if none stand before
    std::string above;            ///< the line of words above it, for the first value under such a line; else empty
    bool above_is_title = false;  ///< that line is the heading's own
    std::string printed;          ///< as printed, one line, at most 200 bytes
    int line = 0;                 ///< 1-based, in the program's output
    int last_line = 0;            ///< the same, of its last number
};

/// A section with more values has only its first and last ones, half of these each.
constexpr std::size_t most_values_in_section = 4000;

struct PrintedLine {
    std::string text;
    int number;  ///< 1-based, in the program's output
};

/// What was printed under one heading.
struct Section {
    int question = 0;  ///< 0 before the first heading
    std::vector<PrintedValue> values;
    std::vector<PrintedLine> lines;  ///< its text, line by line, from the heading's title on
};

struct Transcript {
    std::vector<Section> sections;  ///< in the order printed; a question may come more than once
};

/// Reads a program's output. Any bytes will do; time and memory are linear in their number.
Transcript read_transcript(std::string_view output);

}  // namespace harness
