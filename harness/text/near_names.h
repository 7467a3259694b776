// What somebody may have meant who wrote a name that there is not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// Those of `names` that are near `wanted`, the nearest first, at most three: the same in other letters (upper or
/// lower case), with it as a part, or with few letters changed.
std::vector<std::string> near_names(std::string_view wanted, const std::vector<std::string>& names);

/// For the end of a message: "did you mean s05 or s06?", or "there are s01, s02, …" where none is near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace harness
