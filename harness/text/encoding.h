// Text in other encodings, and in other forms of Unicode.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace harness {

/// The text with a letter and its accents as one character if Unicode has one (NFC), so that a name is the same from
/// every system. Empty if it is not UTF-8.
std::optional<std::string> composed(std::string_view text);

/// Same, but text that is not UTF-8 is returned unchanged.
std::string composed_name(const std::string& name);

/// Converts to UTF-8 from an encoding that iconv knows. Bytes that cannot be converted become U+FFFD.
std::string utf8_from(const char* encoding, std::string_view text);

}  // namespace harness
