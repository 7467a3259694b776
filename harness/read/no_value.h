// Finds words that say that there is no value, or no hit.
#pragma once

#include <optional>
#include <string_view>

#include "harness/read/printed_value.h"

namespace harness {

/// Reads the words that say there is no value or no hit, alone on a line or beside its numbers, and the label before
/// them, if any: "t: none", "t is none", "d = -91 < 0, so no intersection", "hit? no", "t: -". Empty if the line sets a
/// condition ("if …"), is a question, is about a part ("no hit with the caps"), or denies the miss.
std::optional<PrintedValue> read_no_value(std::string_view line);

/// Whether the line only says that the question was not answered: "not done", "TODO".
bool says_not_answered(std::string_view line);

}  // namespace harness
