// What numbers the parts of a question: "a)", "(B)", "iii.", "Part c:".
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/sections/headings.h"

namespace harness {

/// For each line where the number of its part ends, a byte offset; 0 for a line that begins with none. Such numbers
/// count only if they begin with the first and go up one by one under their heading, two at least: a label such as
/// "b)" alone is an answer's name. `headings` are those of the lines.
std::vector<std::size_t> find_parts(const std::vector<std::string_view>& lines,
                                    const std::vector<std::optional<Heading>>& headings);

}  // namespace harness
