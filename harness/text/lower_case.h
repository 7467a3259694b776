// Compares words regardless of case.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Converts ASCII's capital letters to lower case; any other byte stays the same.
std::string lower_case(std::string_view text);

}  // namespace harness
