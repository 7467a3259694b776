// How each item follows from items before it, by the stages of the reference: the ground of follow-through.
#pragma once

#include <span>
#include <vector>

#include "harness/known.h"
#include "harness/real_scene.h"

namespace harness {

/// Whether the student's coefficients are those of a t^2 + 2 b' t + c = 0, with d' = b'^2 - ac.
enum class QuadraticForm { full, half_b };

/// One way to compute an item. An item may have several.
struct Derivation {
    ItemId item;
    std::vector<ItemId> inputs;
    /// Every value that the inputs can give; more than one where intervals leave a decision open. None when the
    /// substitution is degenerate and says nothing, such as a direction of length 0.
    std::vector<Target> (*compute)(const Known& known, const RealScene& scene, QuadraticForm form);
};

std::span<const Derivation> all_derivations();

}  // namespace harness
