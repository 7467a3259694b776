// Which question a student should look at first: mistakes make others further down, so the earliest is the one to mend.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

struct LookFirst {
    int question = 0;
    bool is_missing = false;     ///< nothing is wrong, but this is not there
    bool is_only = false;        ///< no other question is wrong
    std::vector<int> following;  ///< questions without a mistake of their own: they follow from earlier ones
};

/// The earliest question with a wrong answer of its own, or, where there is none, the earliest with one missing. Empty
/// when nothing needs a look, and when there is nothing to look at, as of a source that does not compile or a program
/// that was stopped before it printed an answer.
std::optional<LookFirst> look_first(const Graded& graded);

/// Whether every item is missing.
bool holds_no_answer(const Score& score);

/// Whether a program ended early, or printed nothing, with no answer found in what it printed: how it ended is then all
/// there is to say of it.
bool is_without_answers(const Graded& graded);

/// The same as sentences, plain text; empty when there is nothing to say.
std::string look_first_sentence(const Graded& graded);

}  // namespace harness::report
