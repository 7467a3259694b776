// Writes the values read from a transcript as text that a person can compare with the transcript.
#pragma once

#include <string>
#include <string_view>

/// One line per item, in the handout's order:
///   6.t: 0.585786 @12      a number with its printed decimals, and its line in the output
///   5.V: 0.0 0.0 -1.0 @9   a vector
///   8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @20   the matrix's columns, and how it was printed; if the printout
///                          does not tell "by rows" from "by columns", neither is written and the numbers keep the
///                          order printed
///   6.hit: none @13        words that say there is no such value
///   6.d: ? 1 2 3 @11       numbers of the wrong shape under the item's label
///   10.verdict: triangle first @30
///   9.normal: -            nothing was printed for the item
std::string parsed(std::string_view output);

/// The lines of `parsed` whose item has a value.
std::string parsed_values(std::string_view output);
