// Residuals. If float can't compute an answer on this scene, a correct program may print any number for it. Such an
// answer is judged by how well it solves its own equations with the student's other printed values.
#pragma once

#include <string_view>

#include "harness/mark/diagnose/interval_scene.h"

namespace harness {

enum class Residual {
    small,       ///< the answer solves its equations
    unknown,     ///< a correct program may leave any residual, or the values needed were not printed
    impossible,  ///< no correct program leaves this residual
};

/// `own` are the student's printed values (own_values). "Impossible" is proven for every formulation of reference/key:
/// each bound is that of the last step, which rounds only its own operands. So a hit point is on the ray or at the
/// point that u and v give; a direction has a length of about 1. A solution of the linear system may leave any
/// residual: Cramer's rule divides rounding errors by rounding errors, and only elimination solves the given system.
Residual residual_of(const MatchedItem& printed, const ItemTargets& own, const IntervalScene& scene);

/// An enclosure of the values that a program may have had before it printed this readable value.
Target own_value(const MatchedItem& printed);

/// Explains to the student, in one sentence, the mistake in an answer with an impossible residual.
std::string_view residual_advice(const ItemId& id);

}  // namespace harness
