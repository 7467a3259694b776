// Named mistakes: each is one stage with one change. A wrong answer that is what the changed stage gives gets the mistake's name.
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
    std::vector<Target> (*compute)(const Known& known, const RealScene& scene, const reference::Assignment* assignment);
};

std::span<const Misconception> all_misconceptions();

/// The mistake that explains a wrong printed value, from the student's own inputs first and from the key's else; null when none
/// does, or when its result is too near to what a right stage gives to tell.
const Misconception* find_misconception(const MatchedItem& printed, Evidence& evidence, double allowance);

}  // namespace harness
