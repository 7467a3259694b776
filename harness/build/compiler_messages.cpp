#include "harness/build/compiler_messages.h"

#include <charconv>
#include <optional>
#include <system_error>

#include "harness/text/lines.h"

namespace harness {
namespace {

/// The number at the beginning of `text`; empty if there is none.
std::optional<std::size_t> leading_number(std::string_view text) {
    std::size_t number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc()) return std::nullopt;
    return number;
}

/// The line of the source that a message is about, from 1; empty if it is about no line.
std::optional<std::size_t> own_line(std::string_view message) {
    static const std::string own = std::string(source_name) + ":";
    if (!message.starts_with(own)) return std::nullopt;
    return leading_number(message.substr(own.size()));
}

}  // namespace

bool are_about_lines_below(std::size_t first, std::string_view messages) {
    static const std::string within_own = std::string(source_name) + ": ";
    if (messages.find("; did you mean ") != std::string_view::npos) return false;
    for (const std::string_view line : lines_of(messages)) {
        if (line.starts_with(within_own)) continue;  // "In function 'int main()':", "At global scope:"
        auto number = own_line(line);
        if (const std::size_t text = line.find_first_not_of(' '); text > 0 && text != std::string_view::npos) {
            const std::string_view quoted = line.substr(text);
            if (quoted.starts_with('|')) continue;  // carets below a quoted line
            number = leading_number(quoted);
        }
        if (!number || *number <= first) return false;
    }
    return true;
}

std::vector<std::string> errors_below(std::size_t first, std::string_view messages) {
    std::vector<std::string> errors;
    for (const std::string_view line : lines_of(messages)) {
        const auto number = own_line(line);
        if (number && *number > first && line.find(": error: ") != std::string_view::npos) errors.emplace_back(line);
    }
    return errors;
}

}  // namespace harness
