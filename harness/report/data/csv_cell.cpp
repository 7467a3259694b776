#include "harness/report/data/csv_cell.h"

#include <csv.h>

#include <string_view>

#include "harness/text/escape.h"
#include "harness/text/utf8.h"

namespace harness::report {
namespace {

std::string in_quotes(const std::string& text) {
    std::string quoted(2 * text.size() + 2, '\0');
    quoted.resize(csv_write(quoted.data(), quoted.size(), text.data(), text.size()));
    return quoted;
}

/// Blanks and characters without a width, which some spreadsheets ignore before a formula. escape_control has already
/// made the others visible.
bool is_overlooked(char32_t code) {
    return code == ' ' || code == 0x00A0 || code == 0x00AD || code == 0x034F || code == 0x1680 || code == 0x180E ||
           (code >= 0x2000 && code <= 0x200D) || code == 0x202F || (code >= 0x205F && code <= 0x206F) ||
           code == 0x3000 || code == 0xFEFF;
}

/// Whether a formula begins with this character: = + - @, also in full width, small, superscript or subscript, which
/// some spreadsheets treat alike, or a tab or a new line (OWASP, CSV Injection).
bool begins_a_formula(char32_t code) {
    constexpr std::u32string_view beginnings =
        U"=+-@\t\r\n\uFF1D\uFF0B\uFF0D\uFF20\uFE66\uFE62\uFE63\uFE6B\u207C\u207A\u207B\u208C\u208A\u208B\u2212";
    return beginnings.find(code) != std::u32string_view::npos;
}

bool looks_like_a_formula(std::string_view text) {
    while (!text.empty()) {
        const Decoded first = decode(text);
        if (!is_overlooked(first.code)) return begins_a_formula(first.code);
        text.remove_prefix(first.bytes);
    }
    return false;
}

}  // namespace

std::string csv_cell(const std::string& text) {
    // Control characters are text by now, "\x00", and no formula begins after them.
    std::string safe = escape_control(text);
    if (looks_like_a_formula(safe)) safe.insert(0, 1, '\'');
    return in_quotes(safe);
}

std::string csv_cell_as_it_is(const std::string& text, char separator) {
    // In the first cell, a byte order mark without quotes would be the file's.
    const bool plain = text.find_first_of(std::string("\"\r\n") + separator) == std::string::npos &&
                       !text.starts_with(' ') && !text.ends_with(' ') && !text.starts_with("\xef\xbb\xbf");
    return plain ? text : in_quotes(text);
}

}  // namespace harness::report
