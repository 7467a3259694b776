// Which lines of a source print an answer, and which set what they print, as far as its texts and names tell.
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

/// A line of the source "prints" an item if it has the longest text that stands before the item in the line of the
/// output where the item begins, or alone in the line above: `puts("t = ")` prints what is read from "t = 1.5". Where
/// several lines have that text, each "may print" the item; the likeliest is the first that stands behind the line of
/// the answer before and that of the heading. An item without such a text is on no line.
///
/// A line "sets" a variable that is printed behind this text if it assigns or initialises one of that name. Everything
/// is said of at most the first 64 KiB of the source.
Computing computing_lines(std::string_view source, std::string_view printout, const Score& score);

}  // namespace harness::review
