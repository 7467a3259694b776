// The lines of what a program printed, without what only frames them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace harness {

struct OutputLine {
    std::string_view text;
    int number;  ///< 1-based; pieces of the same line share it
};

/// A program's output as clean text: in the characters that are read, without HTML and, where each line has a number of
/// its own or begins with the same prompt ("out> "), without these. `last_question` tells such numbers from those of
/// questions.
std::string readable_text(std::string_view output, int last_question);

/// The lines of `text`, without the time that a log begins them with. Two questions on one line are two lines. Joins a
/// line that works out a value, "V = (0, 0, -2) / 2", with "= (0, 0, -1)" on the next: in `text`, which the lines point
/// into, a blank replaces the end of the line.
std::vector<OutputLine> split_lines(std::string& text);

}  // namespace harness
