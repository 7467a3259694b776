// The submissions to review, in the order of the review.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/review/session.h"

namespace harness::review {

/// Submissions that need a person for the same reason. One decision may settle all of them.
struct Case {
    Flag concern;                      ///< of the first submission; the others may have different evidence
    std::vector<std::size_t> indices;  ///< submissions where it is open, in the order of the class; not empty
};

/// All open cases of one kind.
struct Chapter {
    std::string kind;
    std::vector<Case> cases;
};

struct Agenda {
    std::vector<Chapter> chapters;   ///< doubtful readings first, lateness without a date last
    std::vector<std::size_t> order;  ///< all submissions: first those with a concern, open or accepted, by its urgency
    std::vector<std::size_t> open;   ///< those with an open concern, in the same order
    std::size_t concerned = 0;       ///< number of submissions with a concern, open or accepted
};

Agenda agenda_of(const Session& session);

/// The neighbors of a submission in the order; empty at either end.
std::optional<std::size_t> before(const Agenda& agenda, std::size_t index);
std::optional<std::size_t> next(const Agenda& agenda, std::size_t index);
/// The next submission with an open concern; continues at the beginning after the end. Empty if there is no other.
std::optional<std::size_t> next_open(const Agenda& agenda, std::size_t index);

}  // namespace harness::review
