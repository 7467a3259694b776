// One cell of a CSV file that a spreadsheet may open.
#pragma once

#include <string>

namespace harness::report {

/// A quoted cell. What a spreadsheet would compute is text behind an apostrophe.
std::string csv_cell(const std::string& text);

}  // namespace harness::report
