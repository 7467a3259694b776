// File names in addresses.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// A path as a URI writes it: every byte but letters, digits and - . _ ~ / as %XX.
std::string in_address(std::string_view path);

}  // namespace harness
