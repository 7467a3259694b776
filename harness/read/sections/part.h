// Finds the numbers of a question's parts: "a)", "(B)", "iii.", "Part c:".
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/sections/headings.h"

namespace harness {

/// For each line, the byte offset where the number of its part ends; 0 for a line that does not begin with one. Part
/// numbers count only if there are at least two under a heading, from the first one up without gaps: a label such as
/// "b)" alone is an answer's name. `headings` are the headings of the lines.
std::vector<std::size_t> find_parts(const std::vector<std::string_view>& lines,
                                    const std::vector<std::optional<Heading>>& headings);

}  // namespace harness
