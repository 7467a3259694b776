// File names are any bytes but '/' and NUL; what a person or a report reads is UTF-8 without control characters.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace harness {

/// `bytes` with each control character and each byte that is not UTF-8 as %XX, so that it is fit for a terminal, JSON
/// and a file name. Other text stays as it is, also a '%'.
std::string printable(std::string_view bytes);

/// The path, printable and in quotes, for a message.
std::string in_quotes(const std::filesystem::path& path);

}  // namespace harness
