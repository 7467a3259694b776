// Comparing words whatever their letters' case.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// With ASCII's capital letters as small ones; any other byte stays as it is.
std::string lower_case(std::string_view text);

}  // namespace harness
