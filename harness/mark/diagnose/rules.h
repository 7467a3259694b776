// Ways to compute an item: correctly from earlier items, or by a named mistake.
#pragma once

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

struct Mistake {
    std::string_view name;    ///< a few words, e.g. "far root"
    std::string_view advice;  ///< one sentence to the student: the mistake and the right way; never a value
    ItemId item;              ///< the item that shows it
    /// The results of the changed stage; none if an input is missing.
    std::vector<Target> (*compute)(const ItemTargets& known, const IntervalScene& scene);
};

}  // namespace harness
