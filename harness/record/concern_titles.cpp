#include "harness/record/concern_titles.h"

#include <algorithm>
#include <array>

namespace harness {
namespace {

/// By urgency.
const std::array<ConcernTitle, 9>& titles() {
    static const std::array<ConcernTitle, 9> table{{
        {"reading_doubtful",
         "raygrade may have misread some answers. Print each answer on its own line, for example t: 1.25",
         "an answer may have been misread", "Doubtful readings"},
        {"hard_coded", "Some answers may be typed into the source", "some answers may be typed into the source",
         "Answers that may be typed into the source"},
        {"other_scene", "The scene in the source is not the assignment's",
         "the scene in the source is not the assignment's", "A different scene"},
        {"scene_of_another", "The answers are right for another student's scene",
         "the answers are right for another student's scene", "Answers for another student's scene"},
        {"mostly_following", "Most points are for consistent answers", "most points are for consistent answers",
         "Mostly consistent answers"},
        {"nondeterministic", "The program's answers differ from run to run", "answers differ from run to run",
         "Answers that differ from run to run"},
        {"variants_not_tried", "The program was not run on all other scenes", "not run on all other scenes",
         "Not run on all other scenes"},
        {std::string(not_graded_concern), "Not graded", "not graded", "Not graded"},
        {"late_without_date", "Late, but the time is unknown", "late, but the time is unknown", "Late, without a date",
         " List the student in a --late-days file or override the mark."},
    }};
    return table;
}

std::size_t rank_of(const std::string& kind) {
    return static_cast<std::size_t>(std::ranges::find(titles(), kind, &ConcernTitle::kind) - titles().begin());
}

}  // namespace

ConcernTitle title_of(const std::string& kind) {
    if (const std::size_t rank = rank_of(kind); rank < titles().size()) return titles()[rank];
    std::string words = kind;
    std::replace(words.begin(), words.end(), '_', ' ');
    return {kind, words, words, words, ""};
}

std::size_t urgency_of(const std::string& kind) {
    const std::size_t rank = rank_of(kind), first_after_unknown = rank_of(std::string(not_graded_concern));
    if (rank == titles().size()) return first_after_unknown;
    return rank < first_after_unknown ? rank : rank + 1;
}

}  // namespace harness
