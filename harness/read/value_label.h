// What a value within a line is called.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The name in the words before a value: what stands before the first '='. Between a name and its value may be anything
/// that is no word: "t ==>", "t ....", "- t:". "P_s = {x =" names the x of P_s.
std::string value_label(std::string_view words);

/// The remark behind a matrix that tells of rows or columns, without brackets: "column-major"; empty if there is none.
std::string note_about_order(std::string_view behind);

}  // namespace harness
