// Columns of a table on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace harness::report {

/// Text of a submission fit for a line of a terminal.
std::string one_line(std::string text);

std::size_t code_points(std::string_view text);

/// Cuts or fills to a width in code points, as near as a table gets to columns.
std::string padded(std::string_view text, std::size_t width);

/// How wide the column of the submissions' ids is: no id takes more of a line than this.
constexpr std::size_t narrowest_id = 10;
constexpr std::size_t widest_id = 28;

}  // namespace harness::report
