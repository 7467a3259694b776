// Formulas with numbers put in, which are no values: "2 V.(S - C)" in "b = 2 V.(S - C) = -13.46".
#pragma once

#include <optional>

#include "harness/read/tokens/line_tokens.h"

namespace harness {

/// The index of the token behind the expression that begins with the number or the bracket at `begin`; empty if none
/// begins there. An expression has operands with operators between them, or it is a bracket of such. In "t = 0.5 - u =
/// 2" and "a = 1 (V has length 1). b = -4" there is none: what follows is the next value's label.
/// Linear in the number of tokens of the expression, of which it has at most `most_tokens_in_bracket`.
std::optional<std::size_t> end_of_expression(const LineTokens& tokens, std::size_t begin);

}  // namespace harness
