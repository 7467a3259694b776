// The kinds of concern in one table: what each is called on the terminal, the pages and the review, and its urgency.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace harness {

/// The kind of the concern about a submission that was not graded. Other concerns have the kinds of their flags.
inline constexpr std::string_view not_graded_concern = "not_graded";

struct ConcernTitle {
    std::string kind;
    std::string sentence;      ///< on a submission's pages, before its evidence
    std::string in_a_line;     ///< in a line of the terminal: "answers differ from run to run"
    std::string of_many;       ///< above all who have it: "Answers that differ from run to run"
    std::string way_out = {};  ///< after the evidence: what an instructor can do, where looking does not help
};

/// A kind that this raygrade does not know, as from a newer one's gradebook, is called by its words.
ConcernTitle title_of(const std::string& kind);

/// From 0 for what a review goes through first. A kind that this raygrade does not know comes just before what was not
/// graded.
std::size_t urgency_of(const std::string& kind);

}  // namespace harness
