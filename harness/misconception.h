// Named mistakes: each is one stage with one change. A wrong answer that is what the changed stage gives gets the
// mistake's name.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "harness/follow.h"

namespace harness {

struct Misconception {
    std::string_view name;    ///< a few words, e.g. "far root"
    std::string_view advice;  ///< one sentence to the student: what happened, what is asked; never a value
    ItemId item;              ///< the item it shows in
    /// What the changed stage gives; none when an input is missing.
    std::vector<Target> (*compute)(const Known& known, const RealScene& scene);
};

std::span<const Misconception> all_misconceptions();

/// The mistake that explains a wrong printed value, computed from the student's own earlier values or, failing that,
/// from the key's; null when none does.
const Misconception* find_misconception(const MatchedItem& printed, Evidence& evidence, double allowance);

}  // namespace harness
