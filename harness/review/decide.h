// Makes a person's decisions in a review, for one or several submissions at once, and undoes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/review/session.h"

namespace harness::review {

/// A decision that a person asks for.
struct Wish {
    Decision::Kind kind = Decision::Kind::accepted;
    std::string about;   ///< accepted: the concern's kind; otherwise an item as in an override; may be empty for a
                         ///< comment
    std::string points;  ///< for a decision on points, as written
    std::string lines;   ///< for a decision on a reading: "12", "12-14", "12:2-4"; empty if the item was not printed
    std::string text;    ///< the comment or the reason; may be empty for accepted
    bool accepts_concerns = false;  ///< a decision on points or a reading also accepts the open concerns
};

/// The submissions for which one decision may be right, and what they have in common: "the same layout".
struct Group {
    std::string cause;
    std::vector<std::size_t> indices;  ///< in the order of the class; if not empty, includes the submission in question
};

/// The submissions that a wish for the submission at `index` may apply to.
Group alike(const Session& session, std::size_t index, const Wish& wish);

/// The submission as it would be after the decision. Throws UsageError if the wish can't be done for it.
Graded after(const Session& session, std::size_t index, const Wish& wish);

/// Applies a wish to these submissions, as one decision. Returns its number. Throws ChangedMeanwhile, and UsageError if
/// the wish can't be done for one of them; then nothing changes.
std::int64_t decide(Session& session, const std::vector<Shown>& shown, const Wish& wish);

/// The result of an undo.
struct Undone {
    std::vector<std::string> submissions;  ///< submissions for which it was undone
    std::vector<std::string> left;         ///< submissions whose points or reading somebody changed later; those stay
};

/// Undoes a decision, only for the submission `only` if that is not empty. The earlier override or reread counts again.
Undone undo(Session& session, std::int64_t number, const std::string& only = "");

/// Takes back points ("6.t", "6", "total") or a reading, no matter who gave it. Throws ChangedMeanwhile, and UsageError
/// if there is none.
void take_back(Session& session, const Shown& shown, Decision::Kind kind, const std::string& item);

}  // namespace harness::review
