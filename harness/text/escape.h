// Makes untrusted bytes safe to show.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Returns the text as valid UTF-8 without control characters other than '\n' and '\t'. Control characters, bytes that
/// are not UTF-8 and characters that change the direction of text become visible as "\x1b" or "\u202e".
std::string escape_control(std::string_view bytes);

/// A path as a URI writes it: every byte but letters, digits and - . _ ~ / as %XX.
std::string in_address(std::string_view path);

}  // namespace harness
