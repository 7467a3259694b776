// One cell of a CSV file that a spreadsheet will open.
#pragma once

#include <string>

namespace harness::report {

/// Quoted as RFC 4180 has it, control bytes escaped. What a spreadsheet would compute is text behind an apostrophe.
std::string csv_cell(const std::string& text);

}  // namespace harness::report
