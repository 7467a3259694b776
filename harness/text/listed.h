// A list in a sentence.
#pragma once

#include <string>
#include <vector>

namespace harness {

/// "4", "4 and 5", "4, 5 and 6"; empty for no parts.
std::string listed(const std::vector<std::string>& parts);

}  // namespace harness
