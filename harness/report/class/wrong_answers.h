// Groups the students who made the same mistake, because one explanation may help all of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

/// One wrong or missing answer to an item, and who gave it.
struct WrongAnswer {
    reference::ItemSpec spec;
    ItemVerdict verdict = ItemVerdict::wrong;  ///< wrong, unreadable or missing
    bool whole_question = false;               ///< no item of the question was answered
    bool differing = false;                    ///< one entry for several different answers, each given by one student
    std::string diagnosis;                     ///< the misconception's name; empty when none is known
    std::string sentence;                      ///< the mistake, in the words that the student reads
    std::string printed;           ///< by the first student; empty if nothing was printed or the answers differ
    std::vector<std::size_t> who;  ///< positions in the class, ascending
};

struct QuestionMistakes {
    int question = 0;
    std::string title;
    std::vector<WrongAnswer> answers;  ///< most shared first; answers that nobody shares last
    std::size_t following = 0;         ///< submissions whose only errors here follow from earlier mistakes
};

/// One entry per question, from the programs with at least one answer. Two answers are the same if they have the same
/// diagnosis or, without a diagnosis, the same gist.
std::vector<QuestionMistakes> mistakes_by_question(const std::vector<Graded>& graded);

/// A text that is equal for equivalent answers: their numbers to four significant digits or, without numbers, their
/// words.
std::string gist_of(std::string_view printed);

}  // namespace harness::report
