// How each item follows from earlier items by the stages of the reference. Follow-through is based on this.
#pragma once

#include <span>

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

std::span<const Derivation> all_derivations();

/// The items that rounding may decide in a correct program (see close_call.h).
std::span<const ItemId> close_call_items();

/// Whether the item can follow from earlier answers, and is not computed from the assignment's numbers alone, as Z_vcs
/// is.
bool can_follow(const ItemId& item);

}  // namespace harness
