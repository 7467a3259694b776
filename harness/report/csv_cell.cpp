#include "harness/report/csv_cell.h"

#include <csv.h>

#include <string_view>

#include "harness/clean_text.h"

namespace harness::report {

std::string csv_cell(const std::string& text) {
    std::string safe = escape_control(text);
    // Some spreadsheets overlook blanks before a formula.
    const std::size_t first = safe.find_first_not_of(' ');
    if (first != std::string::npos && std::string_view("=+-@\t\r").find(safe[first]) != std::string_view::npos)
        safe.insert(0, 1, '\'');
    std::string quoted(2 * safe.size() + 2, '\0');
    quoted.resize(csv_write(quoted.data(), quoted.size(), safe.data(), safe.size()));
    return quoted;
}

}  // namespace harness::report
