// Letters and digits, and comparing words that are written with or without accents, or with a letter wrong.
#pragma once

#include <string>
#include <string_view>

namespace harness {

inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
/// Of any language: each byte of a letter beyond ASCII counts.
inline bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Stands for a letter of another alphabet, or one that is not UTF-8.
constexpr char unknown_letter = '?';

/// The letter in small and without its accent; '\0' for what is no letter.
char plain_letter(char32_t code);

/// The letters of a text, each plain.
std::string plain_letters(std::string_view text);

/// Whether two words differ in at most one letter: wrong, missing, extra, or exchanged with the next.
bool is_one_letter_off(std::string_view word, std::string_view right);

}  // namespace harness
