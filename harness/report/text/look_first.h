// The question that a student should look at first: the one with the earliest mistake, because it causes later ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

struct LookFirst {
    int question = 0;
    std::string own_scene;       ///< "Your source sets center = …", if that comes before all questions
    bool is_missing = false;     ///< no answer is wrong, but this question has a missing answer
    bool ended_early = false;    ///< the program did not run to its end; look at that before this question
    bool is_only = false;        ///< no other question is wrong
    std::vector<int> following;  ///< questions whose only mistakes follow from earlier answers
    std::vector<int> lacking;  ///< questions with a missing but no wrong answer, if another is wrong and the output is
                               ///< complete
};

/// The earliest question with a wrong answer that does not follow from others or, if there is none, the earliest with a
/// missing answer. If the source states a different scene, a question that lost points because of it counts too. Empty
/// if nothing needs a look or no answer was found.
std::optional<LookFirst> look_first(const Graded& graded);

/// Whether every item is missing.
bool holds_no_answer(const Score& score);

/// Whether the program ended early or printed nothing, and no answer was found. Then only the way it ended is worth
/// reporting.
bool is_without_answers(const Graded& graded);

/// The reason to look there first: "it is the only one with a wrong answer." Plain text, one or two sentences.
std::string reason(const LookFirst& look);

/// "Start with question 3", "Start with the scene in your source", or "Then look at question 3" if the program did not
/// run to its end.
std::string invitation(const LookFirst& look);

/// The invitation, ": " and the reason; empty if look_first() is.
std::string look_first_sentence(const Graded& graded);

}  // namespace harness::report
