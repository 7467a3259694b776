// What each kind of concern is called: one table for the terminal, the pages and the review.
#pragma once

#include <string>

namespace harness {

struct ConcernTitle {
    std::string kind;
    std::string sentence;      ///< on a submission's pages, before its evidence
    std::string in_a_line;     ///< in a line of the terminal: "answers differ from run to run"
    std::string of_many;       ///< above all who have it: "Answers that differ between runs"
    std::string way_out = {};  ///< after the evidence: what an instructor can do, where looking does not help
};

/// A kind that this raygrade does not know, as from a newer one's gradebook, is called by its words.
ConcernTitle title_of(const std::string& kind);

}  // namespace harness
