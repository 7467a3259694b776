// UTF-8, one code point at a time.
#pragma once

#include <cstddef>
#include <string_view>

namespace harness {

/// The code point returned for bytes that are not UTF-8.
constexpr char32_t replacement = 0xFFFD;

struct Decoded {
    char32_t code;
    std::size_t bytes;  ///< 1 to 4; 1 for an invalid byte, whose code is U+FFFD
};

/// Decodes the first code point of `text`, which must not be empty (RFC 3629: no overlong forms, no surrogates, at most
/// U+10FFFF).
Decoded decode(std::string_view text);

/// Whether the byte continues a code point that began before it.
bool is_continuation(char c);

/// Whether it is a control character: C0, DEL or C1.
bool is_control(char32_t code);

/// Whether the character reverses the order of the text after it, or ends a line without a newline. Such characters
/// make a text look like a different text (Unicode Technical Report 36).
bool deceives(char32_t code);

/// The beginning of a text: at most `most` bytes, and up to 3 fewer so that no code point is cut.
std::string_view beginning_of_characters(std::string_view text, std::size_t most);

}  // namespace harness
