#include "harness/build/compiler_messages.h"

#include <algorithm>
#include <cerrno>
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

/// The line of the source that a message is about, from 1; empty if it is about none.
std::optional<std::size_t> own_line(std::string_view message) {
    static const std::string own = std::string(source_name) + ":";
    if (!message.starts_with(own)) return std::nullopt;
    return leading_number(message.substr(own.size()));
}

/// Whether a line ends with what the machine says of itself, such as "No space left on device", or says that the
/// compiler is out of memory.
bool names_the_machine(std::string_view line) {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all{"virtual memory exhausted", "memory exhausted"};
        for (const int error : {ENOSPC, EDQUOT, ENOMEM, EMFILE, ENFILE, EAGAIN, EIO, EROFS})
            all.push_back(std::generic_category().message(error));
        return all;
    }();
    return std::ranges::any_of(words, [&](const std::string& word) { return line.ends_with(word); }) ||
           line.find(": out of memory allocating ") != std::string_view::npos;  // cc1plus goes on: "65536 bytes"
}

/// Whether a line says that the source is wrong. A fatal error at a place in it may be the machine's: an included file
/// that can't be opened, an output that can't be written.
bool is_error_of_source(std::string_view line) {
    for (const std::string_view words : {": error: ", ": undefined reference to ", ": multiple definition of "}) {
        if (line.find(words) != std::string_view::npos) return true;
    }
    const auto stands_at_a_place = [&](std::string_view words) {
        const std::string_view place = line.substr(0, line.find(words));
        const std::size_t before_number = place.find_last_not_of("0123456789");
        return place.size() < line.size() && before_number != std::string_view::npos && place[before_number] == ':';
    };
    return stands_at_a_place(": Error: ") ||  // the assembler's
           (stands_at_a_place(": fatal error: ") && !names_the_machine(line));
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

bool blames_the_machine(const std::string& messages) {
    bool is_blamed = false;
    for (const std::string_view line : lines_of(messages)) {
        // Lines that quote the source begin with a blank.
        if (line.starts_with(' ') || line.starts_with("collect2: error: ld returned ")) continue;
        if (is_error_of_source(line)) return false;
        is_blamed = is_blamed || (names_the_machine(line) && line.find(": warning: ") == std::string_view::npos);
    }
    return is_blamed;
}

}  // namespace harness
