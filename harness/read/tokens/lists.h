// Lists whose numbers are separated by something else than commas, blanks or bars: "1 / 2 / 3", "1 in x, 2 in y, 3 in
// z", "1 i + 2 j - 3 k", "x 1 y 2 z 3".
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// What stands between the numbers of a line, the same each time, separates the numbers of a list of three or more;
/// names of components count as the same. Puts commas for such separators, and brackets around a list whose components
/// have names. The tokens stay in order and still point to their bytes of the line.
void join_lists(std::vector<Token>& tokens, std::string_view line);

}  // namespace harness
