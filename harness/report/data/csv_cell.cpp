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
    // Some spreadsheets overlook blanks before a formula.
    const std::size_t first = safe.find_first_not_of(' ');
    if (first != std::string::npos && std::string_view("=+-@\t\r").find(safe[first]) != std::string_view::npos)
        safe.insert(0, 1, '\'');
    return quoted(safe);
}

std::string csv_cell_as_it_is(const std::string& text, char separator) {
    const bool plain = text.find_first_of(std::string("\"\r\n") + separator) == std::string::npos &&
                       !text.starts_with(' ') && !text.ends_with(' ');
    return plain ? text : quoted(text);
}

}  // namespace harness::report
