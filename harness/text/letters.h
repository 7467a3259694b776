// Letters and digits.
#pragma once

namespace harness {

inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
/// A letter of any language: each byte of a letter beyond ASCII counts.
inline bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace harness
