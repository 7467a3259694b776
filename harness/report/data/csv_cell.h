// One cell of a CSV file that a spreadsheet will open.
#pragma once

#include <string>

namespace harness::report {

/// Quoted as RFC 4180 has it, control bytes escaped. What a spreadsheet would compute is text behind an apostrophe.
std::string csv_cell(const std::string& text);

/// The very bytes of a cell that was in a file before, in quotes only where it needs them.
std::string csv_cell_as_it_is(const std::string& text, char separator = ',');

}  // namespace harness::report
