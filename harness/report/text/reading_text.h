// How an output was read, line by line.
#pragma once

#include <string>
#include <string_view>

#include "harness/mark/score/score.h"

namespace harness::report {

/// Each line of the output with its number and the answers that were read from it; below them, the missing and doubtful
/// answers. For a terminal: the student's text is escaped and cut to a width.
std::string reading_text(std::string_view output, const Score& score);

/// The same as JSON: `schema`, `points`, `max_points`, `lines` (number, text, read_as) and `items` (question, name,
/// verdict, printed, line, last_line, found_by, doubt, look_at).
std::string reading_json(std::string_view output, const Score& score);

}  // namespace harness::report
