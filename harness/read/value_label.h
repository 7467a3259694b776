// Finds the name of a value within a line.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The name in the words before a value: the text before the first '='. Anything but a word may come between a name and
/// its value: "t ==>", "t ....", "- t:". In "P_s = {x =" the name is the x of P_s.
std::string value_label(std::string_view words);

}  // namespace harness
