// The question that a student should look at first: the earliest mistake, as it causes others further down.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

struct LookFirst {
    int question = 0;
    std::string own_scene;       ///< "Your source sets center = …", if that comes before all questions
    bool is_missing = false;     ///< no answer is wrong, but this question lacks one
    bool ended_early = false;    ///< the program did not run to its end, which comes before this
    bool is_only = false;        ///< no other question is wrong
    std::vector<int> following;  ///< questions whose only mistakes follow from earlier answers
    std::vector<int> lacking;  ///< questions without a wrong answer that lack one, if one is wrong and all was printed
};

/// The earliest question with a wrong answer of its own or, if there is none, the earliest with a missing answer; where
/// the scene in the source is not the assignment's, also one that lost points by that. Empty if nothing needs a look,
/// or if no answer was found.
std::optional<LookFirst> look_first(const Graded& graded);

/// Whether every item is missing.
bool holds_no_answer(const Score& score);

/// Whether the program ended early or printed nothing, and no answer was found: only how it ended is then worth
/// reporting.
bool is_without_answers(const Graded& graded);

/// Why to look there first: "it is the only one with a wrong answer." In plain text, one or two sentences.
std::string reason(const LookFirst& look);

/// "Start with question 3", "Start with the scene in your source", or "Then look at question 3" if the program did not
/// run to its end.
std::string invitation(const LookFirst& look);

/// The invitation, ": " and the reason; empty if look_first() is.
std::string look_first_sentence(const Graded& graded);

}  // namespace harness::report
