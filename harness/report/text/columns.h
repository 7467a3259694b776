// Columns of a table on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace harness::report {

/// Makes a submission's text fit for one line of a terminal.
std::string one_line(std::string text);

std::size_t code_points(std::string_view text);

/// Cuts or pads to a width in code points; each counts as one column of the terminal.
std::string padded(std::string_view text, std::size_t width);

/// Limits for the width of the column of submission ids; longer ids are cut.
constexpr std::size_t narrowest_id = 10;
constexpr std::size_t widest_id = 28;

}  // namespace harness::report
