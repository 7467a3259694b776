// A named mistake: a stage with a single change. A wrong answer that equals the result of the changed stage gets the
// mistake's name.
#pragma once

#include <string_view>
#include <vector>

#include "harness/mark/compare/item_targets.h"
#include "harness/mark/diagnose/interval_scene.h"

namespace harness {

struct Mistake {
    std::string_view name;    ///< a few words, e.g. "far root"
    std::string_view advice;  ///< one sentence to the student: what happened, what is asked; never a value
    ItemId item;              ///< the item that shows it
    /// The results of the changed stage; none if an input is missing.
    std::vector<Target> (*compute)(const ItemTargets& known, const IntervalScene& scene);
};

}  // namespace harness
