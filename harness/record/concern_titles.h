// A table of the kinds of concern: their titles on the terminal, the pages and the review, and their urgency.
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
    std::string of_many;       ///< the heading above all submissions with it: "Answers that differ from run to run"
    std::string way_out = {};  ///< after the evidence: advice to the instructor if looking does not help
};

/// For a kind that this raygrade does not know, such as one from a newer version's gradebook, the title is made from
/// the words of its name.
ConcernTitle title_of(const std::string& kind);

/// From 0, the kind that comes first in a review. An unknown kind comes just before not_graded.
std::size_t urgency_of(const std::string& kind);

}  // namespace harness
