// Another pixel and small changes to the scene, with which an assignment shows more mistakes.
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
    std::vector<std::string> changes;  ///< "pixel = (190, 60), before pixel = (150, 100)"
    ShownMistakes before;              ///< what the assignment's own scene shows
    ShownMistakes mistakes;            ///< what this one shows
};

/// How far the search goes and where it begins.
struct Search {
    int steps = 150;
    std::uint64_t seed = 1;
    std::function<void(double done)> progress = {};  ///< in [0, 1]
};

/// The best scene that was found. The ray hits as many objects as in the assignment's, no decision hangs on a rounding
/// in float, and numbers are moved by halves. The assignment's own scene if none is better. The same for the same
/// search on every machine.
Proposal propose(const reference::Assignment& assignment, const Search& search);

}  // namespace harness::prepare
