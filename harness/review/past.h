// The decisions of reviews, as a person reads them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/class_run/kept_class.h"

namespace harness::review {

/// Who took a decision back, and for which submissions.
struct TakenBack {
    std::vector<std::string> submissions;
    std::string by;
    std::string when;  ///< in UTC, ISO 8601
};

/// What was decided at one time, for one submission or for several.
struct PastDecision {
    std::int64_t number = 0;
    std::string what;                      ///< "Points for 5.V given"
    std::vector<std::string> submissions;  ///< ids, in the order in which they were decided; also those taken back
    std::vector<std::string> in_force;     ///< those for which it counts
    std::vector<TakenBack> taken_back;     ///< the oldest first
    std::string by;
    std::string when;  ///< in UTC, ISO 8601
    std::string why;   ///< the reason or the comment; may be empty
};

/// The newest first, with those that were undone.
std::vector<PastDecision> past_decisions(const KeptClass& kept);

/// The name by which the review speaks of a submission: "Doe, Jane"; its id if it is no longer in the class.
std::string name_of(const KeptClass& kept, const std::string& id);

/// "Decision 3: Accepted for ann; ben."; empty if there is none of this number in force.
std::string sentence_of(const KeptClass& kept, std::int64_t number);

/// "It lowers the mark from 92 to 50." or "It lowers points of 3 students."; empty if the decision lowers none.
std::string lowered_sentence(const KeptClass& kept, std::int64_t number);
std::string lowered_sentence(const std::vector<std::string>& lowered);

}  // namespace harness::review
