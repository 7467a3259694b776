// From the bytes a program wrote to text that can be read and shown.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Valid UTF-8 without control characters other than '\n' and '\t': terminal escapes are removed, CR LF and CR end a
/// line, bytes that are not UTF-8 become U+FFFD. What stands for ASCII is ASCII afterwards: the minus sign U+2212 and
/// dashes, no-break spaces, angle and box brackets, sub- and superscript digits ("t₁" is "t1", "b²" is "b^2"), Greek
/// letters by name. Linear in the number of bytes; a line stays a line, so line numbers are the program's.
std::string clean_text(std::string_view bytes);

/// The beginning of a text, `most` bytes of it or up to 3 less, so that no character of UTF-8 is cut.
std::string_view beginning_of_characters(std::string_view text, std::size_t most);

/// The same bytes made safe to show: as clean_text, but nothing is rewritten to ASCII and escapes stay visible as
/// "\x1b".
std::string escape_control(std::string_view bytes);

}  // namespace harness
