// A way in which an item follows from earlier items.
#pragma once

#include <vector>

#include "harness/mark/compare/item_targets.h"
#include "harness/mark/compare/quadratic_form.h"
#include "harness/mark/diagnose/interval_scene.h"

namespace harness {

/// One way to compute an item. An item may have several.
struct Derivation {
    ItemId item;
    std::vector<ItemId> inputs;
    /// Every value that the inputs can give: several if intervals leave a decision open, none if the inputs are
    /// degenerate, such as a direction of length 0.
    std::vector<Target> (*compute)(const ItemTargets& known, const IntervalScene& scene, QuadraticForm form);
};

}  // namespace harness
