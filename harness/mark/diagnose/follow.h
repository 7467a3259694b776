// Follow-through: whether a wrong answer follows from the student's own earlier wrong answers.
#pragma once

#include <optional>
#include <vector>

#include "harness/mark/diagnose/evidence.h"

namespace harness {

/// A printed value agrees with a computed one.
struct Agreement {
    std::optional<SystemForm> system;        ///< the layout, for the triangle's matrix; empty for every other item
    std::optional<QuadraticForm> form = {};  ///< from follows(): the form of the quadratic in which it follows
};

/// Agrees if a correct stage gives the printed value for the student's own inputs, and at least one input deviates from
/// the key. The key's value may replace an input that was printed correctly, because printing rounded that input; it
/// always replaces an input that was not printed. A trivial result does not count, nor does one that is too
/// wide, unless float can't narrow it: the inputs were printed with all digits. nan and infinity follow if the
/// student's own values give no finite result, unless the student has no right answer.
std::optional<Agreement> follows(const MatchedItem& printed, const Evidence& evidence, double allowance);

/// Whether a computed value is narrow enough to compare a printed value with.
bool says_something(const Target& target);

/// Agrees if the printed value is one of `targets`. The triangle's matrix may have any column order; its right-hand
/// side may have the row factors of evidence.system.
std::optional<Agreement> is_one_of(const MatchedItem& printed, const std::vector<Target>& targets,
                                   const Evidence& evidence, double allowance);

}  // namespace harness
