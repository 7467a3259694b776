#include "harness/report/data/csv_cell.h"

#include <csv.h>

#include <string_view>

#include "harness/text/escape.h"

namespace harness::report {
namespace {

std::string quoted(const std::string& text) {
    std::string quoted(2 * text.size() + 2, '\0');
    quoted.resize(csv_write(quoted.data(), quoted.size(), text.data(), text.size()));
    return quoted;
}

}  // namespace

std::string csv_cell(const std::string& text) {
    std::string safe = escape_control(text);
    // Some spreadsheets overlook blanks and empty lines before a formula.
    const std::size_t first = safe.find_first_not_of(" \n");
    if (first != std::string::npos && std::string_view("=+-@\t\r").find(safe[first]) != std::string_view::npos)
        safe.insert(0, 1, '\'');
    return quoted(safe);
}

std::string csv_cell_as_it_is(const std::string& text, char separator) {
    // A byte order mark without quotes would be the file's if the cell is its first.
    const bool plain = text.find_first_of(std::string("\"\r\n") + separator) == std::string::npos &&
                       !text.starts_with(' ') && !text.ends_with(' ') && !text.starts_with("\xef\xbb\xbf");
    return plain ? text : quoted(text);
}

}  // namespace harness::report
