#include "harness/text/printable.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace harness {
namespace {

std::uint8_t byte_at(std::string_view text, std::size_t at) {
    return static_cast<std::uint8_t>(text[at]);
}

/// How many bytes the UTF-8 character at `at` has; 0 when there is no valid one (Unicode 15, table 3-7: no overlong
/// forms, no surrogates, nothing beyond U+10FFFF).
std::size_t character_length(std::string_view text, std::size_t at) {
    const std::uint8_t first = byte_at(text, at);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first <= 0xDF ? 2 : first >= 0xE0 && first <= 0xEF ? 3 : 4;
    if (first < 0xC2 || first > 0xF4 || text.size() - at < length) return 0;
    const std::uint8_t second = byte_at(text, at + 1);
    const std::uint8_t lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const std::uint8_t highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (second < lowest || second > highest) return 0;
    for (std::size_t i = 2; i < length; ++i) {
        if ((byte_at(text, at + i) & 0xC0) != 0x80) return 0;
    }
    return length;
}

/// C0, DEL, C1 (U+0080 to U+009F), which terminals obey as well, and the characters that reverse the order of text.
bool is_control(std::string_view character) {
    constexpr std::string_view turning[] = {"\u061C", "\u200E", "\u200F", "\u2028", "\u2029", "\u202A", "\u202B",
                                            "\u202C", "\u202D", "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"};
    const std::uint8_t first = byte_at(character, 0);
    return first < 0x20 || first == 0x7F || (first == 0xC2 && byte_at(character, 1) < 0xA0) ||
           std::find(std::begin(turning), std::end(turning), character) != std::end(turning);
}

}  // namespace

std::string printable(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t length = character_length(bytes, at);
        const auto character = bytes.substr(at, length == 0 ? 1 : length);
        at += character.size();
        if (length > 0 && !is_control(character)) {
            text += character;
            continue;
        }
        for (std::size_t i = 0; i < character.size(); ++i) {
            const std::uint8_t byte = byte_at(character, i);
            text += {'%', digits[byte >> 4], digits[byte & 0x0F]};
        }
    }
    return text;
}

std::string in_quotes(const std::filesystem::path& path) {
    return '"' + printable(path.native()) + '"';
}

}  // namespace harness
