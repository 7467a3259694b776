#include "harness/record/concern_titles.h"

#include <algorithm>
#include <array>

namespace harness {
namespace {

/// By urgency.
const std::array<ConcernTitle, 9>& titles() {
    static const std::array<ConcernTitle, 9> table{{
        {"reading_doubtful",
         "Some answers may not have been read as they were meant; each is best on a line of its own, as in t: 1.25",
         "an answer may have been misread", "Doubtful readings"},
        {"hard_coded", "Printed numbers may not depend on the scene in the source",
         "printed numbers may not depend on the scene", "Answers that may be written into the program"},
        {"other_scene", "The source states another scene than the assignment", "the source states another scene",
         "A different scene"},
        {"scene_of_another", "The answers are those of another scene than this student's",
         "the answers are those of another scene than this student's", "A scene that was not dealt to this student"},
        {"mostly_following", "Most points are for answers that follow from wrong ones",
         "most points are for what follows from wrong answers", "Points for what follows from wrong answers"},
        {"nondeterministic", "The program's answers differ from run to run", "answers differ from run to run",
         "Answers that differ between runs"},
        {"variants_not_tried", "The program could not be tried in full on other scenes",
         "not tried in full on other scenes", "Not tried on other scenes"},
        {std::string(not_graded_concern), "Not graded", "not graded", "Not graded"},
        {"late_without_date", "Late, by an unknown time", "late, by an unknown time", "Late, without a date",
         " List it in a file for --late-days, or override the mark."},
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
