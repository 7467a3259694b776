// Looks for another pixel and small changes to the scene that reveal more mistakes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/prepare/shown_mistakes.h"
#include "reference/toml/assignment.h"

namespace harness::prepare {

struct Proposal {
    reference::Scene<reference::Decimal> scene;
    std::vector<std::string> changes;  ///< "pixel = (190, 60) (was pixel = (150, 100))"
    ShownMistakes before;              ///< in the assignment's own scene
    ShownMistakes mistakes;            ///< in this one
};

/// How many scenes the search tries, and its random seed.
struct Search {
    int steps = 150;
    std::uint64_t seed = 1;
    std::function<void(double done)> progress = {};  ///< in [0, 1]
};

/// The best scene found, or the assignment's own if none is better. The ray hits as many objects as in the assignment's
/// scene, rounding in float cannot change a decision, and numbers move in steps of 1/2. The same search gives the same
/// scene on every machine.
Proposal propose(const reference::Assignment& assignment, const Search& search);

}  // namespace harness::prepare
