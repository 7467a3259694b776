// Finds the lines of a source that print an answer and those that set the printed variable, by text and names only.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "harness/report/page/listing.h"

namespace harness::review {

struct Computing {
    report::LineNotes notes;                     ///< "prints 6.t", "sets t, printed as 6.t"
    std::map<std::string, std::set<int>> lines;  ///< by item, the lines of notes on its likeliest printing
    std::map<std::string, int> first_printing;   ///< by item, the first line that prints it or may print it
};

/// A line of the source "prints" an item if it contains the longest text that appears before the item on its first
/// output line, or alone on the line above: `puts("t = ")` prints the item read from "t = 1.5". If several lines
/// contain that text, each "may print" the item; the likeliest is the first one after the line of the previous answer
/// and the line of the heading. An item without such a text is on no line.
///
/// A line "sets" a variable printed after this text if it assigns or initializes a variable with that name. Looks only
/// at the first 64 KiB of the source.
Computing computing_lines(std::string_view source, std::string_view printout, const Score& score);

}  // namespace harness::review
