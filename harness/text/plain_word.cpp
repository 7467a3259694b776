#include "harness/text/plain_word.h"

#include <algorithm>

#include "harness/text/utf8.h"

namespace harness {

char plain_letter(char32_t code) {
    if (code >= 'A' && code <= 'Z') return static_cast<char>(code - 'A' + 'a');
    if (code < 0x80) return code >= 'a' && code <= 'z' ? static_cast<char>(code) : '\0';
    // U+00C0 to U+00FF; '0' for the multiplication and division signs.
    constexpr std::string_view latin_1 = "aaaaaaaceeeeiiiidnooooo0ouuuuypsaaaaaaaceeeeiiiidnooooo0ouuuuypy";
    // U+0100 to U+017F
    constexpr std::string_view extended_a =
        "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuu"
        "uuuuuuww"
        "yyyzzzzzzs";
    static_assert(extended_a.size() == 0x80);
    if (code < 0xC0) return '\0';
    if (code > 0x17F) return unknown_letter;
    if (code > 0xFF) return extended_a[code - 0x100];
    const char plain = latin_1[code - 0xC0];
    return plain == '0' ? '\0' : plain;
}

std::string plain_letters(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        const Decoded decoded = decode(text);
        if (const char letter = plain_letter(decoded.code); letter != '\0') plain += letter;
        text.remove_prefix(decoded.bytes);
    }
    return plain;
}

bool is_one_letter_off(std::string_view word, std::string_view right) {
    if (word.size() > right.size() + 1 || right.size() > word.size() + 1) return false;
    const auto same = static_cast<std::size_t>(
        std::mismatch(word.begin(), word.end(), right.begin(), right.end()).first - word.begin());
    const std::string_view left = word.substr(same), other = right.substr(same);
    if (left.empty() || other.empty()) return true;
    if (left.substr(1) == other.substr(1) || left.substr(1) == other || left == other.substr(1)) return true;
    const bool exchanged = left.size() >= 2 && other.size() >= 2 && left[0] == other[1] && left[1] == other[0];
    return exchanged && left.substr(2) == other.substr(2);
}

}  // namespace harness
