// Suggestions for a name that does not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reference {

/// Up to three of `names` that resemble `wanted`, the nearest first. Such a name contains `wanted` or differs from it
/// in few letters; upper and lower case count as equal.
std::vector<std::string> near_names(std::string_view wanted, const std::vector<std::string>& names);

/// For the end of a message: "did you mean s05 or s06?", or "there are s01, s02, …" if none is near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace reference
