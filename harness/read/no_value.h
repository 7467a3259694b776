// Words that say that there is no value, or no hit.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {

/// Reads the words of a line, or beside its numbers, that say that there is no value or no hit, and the label before
/// them if there is one: "t: none", "t is none", "N -> (not defined)", "it is not hit", "d = -91 < 0, so no
/// intersection", "hit? no", "t -". Empty if the line sets a condition ("if …"), speaks of a part ("no hit with the
/// caps"), or denies the miss.
std::optional<PrintedValue> read_no_value(std::string_view line);

/// Whether the dash at the line's end points to the numbers below: "Normal -" above "0.5 0.5 0.7".
bool is_title_above(std::string_view line, std::string_view next);

/// Whether the line's only value says that nothing is hit: "t = -1 (-1 means no hit)", "t = -1 (no hit)", "hit = 0",
/// "0 intersections", "number of hits: 0".
bool number_means_no_hit(std::string_view line);

/// Whether the line is a flag that stands below a ray parameter and says that it is no hit: "valid = 0", "t > 0:
/// false".
bool flag_denies_hit(std::string_view line);

/// Whether the line only says that the question was not answered: "not done", "TODO".
bool says_not_answered(std::string_view line);

}  // namespace harness
