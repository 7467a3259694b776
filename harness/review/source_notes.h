// Which lines of a source print an answer, as far as the texts in them tell.
#pragma once

#include <string_view>

#include "harness/report/page/listing.h"

namespace harness::review {

/// A line of the source prints an item if it has the longest string literal that stands in the line of the printout
/// where the item begins: `puts("t = ")` prints what is read from "t = 1.5". An item in a line without such a literal
/// is on no line of the source. Where several lines have that literal, each of them "may print" the item.
report::LineNotes printing_lines(std::string_view source, std::string_view printout, const Score& score);

}  // namespace harness::review
