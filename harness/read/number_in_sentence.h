// Numbers on a line that are no values: they count, compare, say where something stands or that something is so.
#pragma once

#include <cstddef>
#include <string_view>

#include "harness/read/printed_value.h"
#include "harness/read/tokens/line_tokens.h"
#include "harness/read/tokens/number_group.h"

namespace harness {

/// Whether the token is a word that a reason follows: "since", "because".
bool is_reason_word(const LineTokens& tokens, std::size_t i);

/// Whether a lone whole number under this label stands in a sentence: "if there are 2 positive roots".
bool is_in_sentence(const LineTokens& tokens, const NumberGroup& found, std::string_view label);

/// Whether the number is what another is compared with, "-13.75, which is less than 0", or is compared to give a
/// reason, "no hit since -91 < 0".
bool is_compared(const LineTokens& tokens, const NumberGroup& found);

/// Whether the number counts the roots that the value before it has: "d = 8 -> 2 roots", "8 => 2 real solutions".
bool counts_roots(const LineTokens& tokens, std::size_t i);

/// Whether the bracket is the index of a matrix' row or column, as in "M(1,:) = 1 0 0 4" and in a line "[0] vec4(1, 0,
/// 0, 0)".
bool is_index_of_row(const LineTokens& tokens, std::size_t open);

/// Whether the value is the 0 of "a t^2 + b t + c = 0", which is not an answer. "u: 1 + -1 = 0" is one. `before` are
/// the words before it.
bool is_zero_of_equation(const PrintedValue& value, std::string_view before);

/// Whether the value is the 1 or 0 of "u >= 0: 1", which says that it is so.
bool is_truth_of_comparison(const PrintedValue& value, std::string_view before);

}  // namespace harness
