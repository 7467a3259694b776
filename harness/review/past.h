// The decisions of reviews, in readable form.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/class_run/kept_class.h"

namespace harness::review {

/// A decision that was taken back: by whom, and for which submissions.
struct TakenBack {
    std::vector<std::string> submissions;
    std::string by;
    std::string when;  ///< in UTC, ISO 8601
};

/// A decision made at one time for one or several submissions.
struct PastDecision {
    std::int64_t number = 0;
    std::string what;                      ///< "Points for 5.V given"
    std::vector<std::string> submissions;  ///< ids in the order of decision, including those taken back
    std::vector<std::string> in_force;     ///< those for which it still counts
    std::vector<TakenBack> taken_back;     ///< oldest first
    std::string by;
    std::string when;  ///< in UTC, ISO 8601
    std::string why;   ///< the reason or the comment; may be empty
};

/// All decisions, including undone ones, newest first.
std::vector<PastDecision> past_decisions(const KeptClass& kept);

/// A submission's name in the review: "Doe, Jane"; its id if it is no longer in the class.
std::string name_of(const KeptClass& kept, const std::string& id);

/// "Decision 3: Accepted for ann; ben."; empty if no decision with this number is in force.
std::string sentence_of(const KeptClass& kept, std::int64_t number);

/// "It lowers the mark from 92 to 50." or "It lowers points of 3 students."; empty if the decision lowers none.
std::string lowered_sentence(const KeptClass& kept, std::int64_t number);
std::string lowered_sentence(const std::vector<std::string>& lowered);

}  // namespace harness::review
