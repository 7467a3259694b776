#include "harness/text/shell_word.h"

#include <fmt/format.h>

#include "harness/text/escape.h"

namespace harness {
namespace {

bool is_plain_in_a_shell(std::string_view word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+:,./-";
    return !word.empty() && word.find_first_not_of(plain) == std::string_view::npos;
}

/// For words with bytes that a terminal may not get: all but ASCII becomes \xNN.
std::string in_escaping_quotes(std::string_view word) {
    std::string text = "$'";
    for (const char c : word) {
        if (c == '\'' || c == '\\') {
            text += fmt::format("\\{}", c);
        } else if (c < ' ' || c > '~') {
            text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
            text += c;
        }
    }
    return text + "'";
}

}  // namespace

std::string in_shell_quotes(std::string_view word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string shell_word(std::string_view word) {
    if (is_plain_in_a_shell(word)) return std::string(word);
    const bool may_be_shown = escape_control(word) == word && word.find_first_of("\n\t") == std::string_view::npos;
    return may_be_shown ? in_shell_quotes(word) : in_escaping_quotes(word);
}

}  // namespace harness
