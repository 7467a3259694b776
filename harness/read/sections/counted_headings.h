// Numbers that head questions only because they count all of them, one behind the other.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/sections/heading.h"

namespace harness {

/// The headings behind one word that is none of the known ones, whose numbers go up one by one from the first question
/// to the last, as in a language that is not known; one entry per line. Empty if there is no such word.
std::vector<std::optional<Heading>> counted_by_a_word(const std::vector<std::string_view>& lines, int last_question);

/// The headings in a column: the first of a table, whose numbers go up one by one from the first question to the last,
/// numbers at the beginning of lines that name at least five questions, what belongs to each standing together, or
/// numbers alone on their lines that go up one by one to the last question; one entry per line. Empty if there are
/// none.
std::vector<std::optional<Heading>> headings_in_column(const std::vector<std::string_view>& lines, int last_question);

}  // namespace harness
