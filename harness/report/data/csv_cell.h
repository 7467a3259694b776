// One cell of a CSV file that a spreadsheet will open.
#pragma once

#include <string>

namespace harness::report {

/// Quotes as in RFC 4180 and escapes control bytes. Puts an apostrophe before text that a spreadsheet would read as a
/// formula, also after blanks and invisible characters, and also for full-width or small + - = @.
std::string csv_cell(const std::string& text);

/// Writes the exact bytes of a cell that was read from a file, in quotes only if needed.
std::string csv_cell_as_it_is(const std::string& text, char separator = ',');

}  // namespace harness::report
