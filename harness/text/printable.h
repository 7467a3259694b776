// File names may contain any bytes but '/' and NUL; people and reports get UTF-8 without control characters.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace harness {

/// Replaces each control character and each byte that is not UTF-8 by %XX, so that the text is safe in a terminal, JSON
/// and a file name. Other text stays the same, even a '%'.
std::string printable(std::string_view bytes);

/// The path, printable and in quotes, for a message.
std::string in_quotes(const std::filesystem::path& path);

}  // namespace harness
