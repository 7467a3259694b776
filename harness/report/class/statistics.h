// The numbers for the class report's first section.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

/// How a class did on one item: the number of programs, of those with at least one answer, by verdict.
struct ItemTally {
    reference::ItemSpec spec;
    std::string question_title;
    std::size_t right = 0;
    std::size_t follow = 0;
    std::size_t wrong = 0;  ///< or unreadable
    std::size_t missing = 0;
    std::size_t all() const { return right + follow + wrong + missing; }
    /// Share of answers, 0 to 1, that are neither right nor follow from an earlier mistake.
    double failed() const;
};

struct OutcomeCount {
    Outcome outcome = Outcome::graded;
    std::vector<std::size_t> who;  ///< positions in the class, ascending
};

struct ClassStatistics {
    std::size_t handed_in = 0;
    std::size_t marked = 0;  ///< submissions with points
    std::size_t late = 0;
    std::size_t to_review = 0;  ///< counted as in `grade` and the review
    std::size_t overridden = 0;
    std::optional<double> mean;  ///< of the final points; empty if nobody has points
    std::optional<double> median;
    double max_points = 0;
    double bin_width = 10;                  ///< of the distribution, in points: 1, 2, 5, 10, 20, 50 and so on
    std::vector<std::size_t> distribution;  ///< number of marks from 0, bin_width, …; the last also counts all higher
                                            ///< marks
    std::vector<OutcomeCount> outcomes;     ///< outcomes that occurred, in the enumeration's order
    std::size_t printed = 0;                ///< programs with at least one answer
    std::vector<ItemTally> items;           ///< hardest first, equally hard items in the handout's order
};

ClassStatistics class_statistics(const std::vector<Graded>& graded);

/// Whether at least one answer was found, so that the answers say something about the student's understanding.
bool has_answers(const Graded& graded);

}  // namespace harness::report
