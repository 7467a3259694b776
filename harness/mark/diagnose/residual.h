// Residuals: an answer that float can't give here is not judged by its number, since a correct program may print any.
// It is judged by how well it solves its own equations with the student's other printed values.
#pragma once

#include <string_view>

#include "harness/mark/diagnose/interval_scene.h"

namespace harness {

enum class Residual {
    small,       ///< the answer solves its equations
    unknown,     ///< a correct program may leave any residual here, or did not print the values that tell
    impossible,  ///< no correct program leaves this residual
};

/// `own` is what the student printed (own_values). Impossible is proven for every formulation of reference/key: each
/// bound is that of the last step, which rounds its own operands and no others. So a hit point is on the ray or where u
/// and v say; a direction has about length 1. A solution of the linear system may leave any residual: Cramer's rule
/// divides rounding by rounding here, and only elimination solves the system that it was given.
Residual residual_of(const MatchedItem& printed, const ItemTargets& own, const IntervalScene& scene);

/// A readable printed value as any program may have had it before it was printed.
Target own_value(const MatchedItem& printed);

/// What is wrong with an answer whose residual is impossible; one sentence to the student.
std::string_view residual_advice(const ItemId& id);

}  // namespace harness
