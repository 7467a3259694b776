// Which of a printout's lines are the headings of its questions.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/sections/heading.h"

namespace harness {

/// Finds the headings among `lines`. Only one style counts: the style that names the most questions, with a
/// preference for the earlier styles. Bare and dotted numbers count only if they name at least three questions, dotted
/// ones only without any other, those in a column as counted_headings says. Returns one entry per line, empty if the
/// line is not a heading.
std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines, int last_question);

}  // namespace harness
