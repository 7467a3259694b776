// An output line by line, with the answers that were read from each line.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "harness/mark/score/score.h"

namespace harness::report {

/// The lines of an output as the reader counts them: "\n", "\r\n" and a lone "\r" end a line. At most `most` of them,
/// without their ends.
std::vector<std::string_view> printout_lines(std::string_view output, std::size_t most);

/// An answer that was read from a line.
struct ReadAnswer {
    std::string item;  ///< "6.t"
    ItemVerdict verdict = ItemVerdict::wrong;
    bool begins = true;     ///< the answer begins on this line and does not continue from the line before
    bool by_order = false;  ///< no label names it
};

/// The item's name on a page, next to its line: "6.t", or "question 10" where the item's name says too little.
std::string shown_item(std::string_view item);

/// By line, from 1, in the order of the questions.
std::map<int, std::vector<ReadAnswer>> answers_by_line(const Score& score);

}  // namespace harness::report
