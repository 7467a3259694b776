// Reads lists whose separators are not commas, blanks or bars: "1 / 2 / 3", "1 in x, 2 in y, 3 in z", "1 i + 2 j - 3
// k", "x 1 y 2 z 3".
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// Text that repeats between three or more numbers of a line separates the numbers of a list; names of components count
/// as repeats. Replaces such separators with commas, and puts brackets around a list whose components have names. The
/// tokens stay in order and still point to their bytes of the line.
void join_lists(std::vector<Token>& tokens, std::string_view line);

}  // namespace harness
