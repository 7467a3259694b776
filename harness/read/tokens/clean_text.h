// Converts the bytes that a program printed into readable text that is safe to show.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Returns valid UTF-8 without control characters other than '\n' and '\t'. Removes terminal escapes; CR LF and CR end
/// a line; bytes that are not UTF-8 become U+FFFD. Lookalikes of ASCII become ASCII: the minus sign U+2212 and dashes,
/// no-break spaces, angle and box brackets, sub- and superscript digits ("t₁" becomes "t1", "b²" becomes "b^2"). Greek
/// letters become their names. Lines are neither joined nor split, so line numbers match the program's output. Linear
/// in the number of bytes.
std::string clean_text(std::string_view bytes);

}  // namespace harness
