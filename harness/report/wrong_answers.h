// Who made the same mistake: one explanation may serve many.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

/// The same wrong answer to one item, or none at all.
struct WrongAnswer {
    reference::ItemSpec spec;
    ItemVerdict verdict = ItemVerdict::wrong;  ///< wrong, unreadable or missing
    bool whole_question = false;               ///< no item of the question was answered
    bool differing = false;                    ///< nobody else printed this: many such, each another
    std::string diagnosis;                     ///< the misconception's name; empty when none is known
    std::string sentence;                      ///< what is wrong, as the student is told
    std::string printed;                       ///< by the first of them; empty when nothing was, or they differ
    std::vector<std::size_t> who;              ///< positions in the class, ascending
};

struct QuestionMistakes {
    int question = 0;
    std::vector<WrongAnswer> answers;  ///< most shared first, the differing last
    std::size_t following = 0;         ///< submissions where it is right but for what follows from earlier mistakes
};

/// By question, those of programs that printed something. Answers are the same that have the same diagnosis or, without
/// one, the same printed numbers to four significant digits.
std::vector<QuestionMistakes> mistakes_by_question(const std::vector<Graded>& graded);

/// What two answers have in common that say the same: their numbers to four significant digits, or their words.
std::string gist_of(std::string_view printed);

}  // namespace harness::report
