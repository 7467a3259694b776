// What a person decides in a review, for one submission or for several at once, and how it is undone.
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
    std::string about;   ///< accepted: the kind of the concern; else an item as an override names it; comment: or empty
    std::string points;  ///< of a decision on points, as written
    std::string lines;   ///< of a decision on a reading: "12", "12-14", "12:2-4"; empty if the item was not printed
    std::string text;    ///< the comment or the reason; may be empty for accepted
    bool accepts_concerns = false;  ///< a decision on points or a reading also accepts what is still open
};

/// The submissions for which one decision may be right, and what they have in common: "the same layout".
struct Group {
    std::string cause;
    std::vector<std::size_t> indices;  ///< in the order of the class; with the submission asked about, if not empty
};

/// Who else a wish for the submission at `index` may be meant for.
Group alike(const Session& session, std::size_t index, const Wish& wish);

/// The submission as it would be after the decision. Throws UsageError if the wish can't be done for it.
Graded after(const Session& session, std::size_t index, const Wish& wish);

/// Decides for these submissions; the changes are one decision. Returns its number. Throws ChangedMeanwhile, and
/// UsageError if the wish can't be done for one of them; then nothing is changed.
std::int64_t decide(Session& session, const std::vector<Shown>& shown, const Wish& wish);

/// What an undo did.
struct Undone {
    std::vector<std::string> submissions;  ///< for which it was undone
    std::vector<std::string> left;         ///< whose points or reading somebody changed later: those stay
};

/// Undoes a decision, for one submission only if `only` is not empty. What an override or a reread replaced counts
/// again.
Undone undo(Session& session, std::int64_t number, const std::string& only = "");

/// Takes back points ("6.t", "6", "total") or a reading, whoever gave it. Throws ChangedMeanwhile, and UsageError if
/// there is none.
void take_back(Session& session, const Shown& shown, Decision::Kind kind, const std::string& item);

}  // namespace harness::review
