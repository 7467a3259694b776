// What a value within a line is called.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The name in the words before a value, up to their first '=', without punctuation around it: "t" of " t = ", "P_s x"
/// of "P_s = {x = ", "t minus" of "t- = ". `remark` is what stands before the words and holds for them too, "check:".
/// Before the first value of a line nothing is said about another one.
std::string value_label(std::string_view words, std::string_view remark, bool is_first);

/// What a note behind a matrix says of its rows or columns: "column-major" of " (column-major)"; empty for other words.
std::string note_about_order(std::string_view behind);

}  // namespace harness
