// An assignment's scene with every number exactly as written, for the stages to run over without a rounding.
#pragma once

#include "reference/assignment.h"
#include "reference/exact/certified.h"

namespace reference {

/// Throws std::domain_error for a number that to_rational refuses; parse_assignment lets none through.
Scene<Rational> rational_scene(const Scene<Decimal>& scene);

/// All its numbers are of one field, which grows as roots are taken: numbers of two scenes don't mix.
Scene<Certified> certified_scene(const Scene<Rational>& scene);

}  // namespace reference
