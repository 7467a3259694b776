// The class at a glance: what the report's first figures are made from.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

/// How a class did on one item: of the programs that printed something, how many were…
struct ItemTally {
    reference::ItemSpec spec;
    std::size_t right = 0;
    std::size_t follow = 0;
    std::size_t wrong = 0;  ///< or unreadable
    std::size_t missing = 0;
    std::size_t all() const { return right + follow + wrong + missing; }
    /// Neither right nor following from an earlier mistake, as a share, 0 to 1.
    double failed() const;
};

struct OutcomeCount {
    Outcome outcome = Outcome::graded;
    std::vector<std::size_t> who;  ///< positions in the class, ascending
};

struct ClassStatistics {
    static constexpr std::size_t bins = 10;

    std::size_t handed_in = 0;
    std::size_t marked = 0;  ///< those with points
    std::size_t late = 0;
    std::size_t flagged = 0;
    std::size_t overridden = 0;
    std::optional<double> mean;  ///< of the final points; empty when nobody has any
    std::optional<double> median;
    double max_points = 0;
    std::array<std::size_t, bins> distribution{};  ///< final points, by tenths of max_points; the last takes all above
    std::vector<OutcomeCount> outcomes;            ///< those that came, in the order of the enumeration
    std::size_t printed = 0;                       ///< programs that printed something
    std::vector<ItemTally> items;                  ///< hardest first, alike ones in the handout's order
};

ClassStatistics class_statistics(const std::vector<Graded>& graded);

/// Whether it printed something, so that its answers tell of its author's understanding.
bool has_answers(const Graded& graded);

/// What a person should look at: a flag, or a finding of the sanitizers.
bool is_flagged(const Graded& graded);

}  // namespace harness::report
