// An assignment's scene in other scalars: exactly as written, or as the nearest double.
#pragma once

#include "reference/numbers/certified.h"
#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"

namespace reference {

inline Scene<double> in_double(const Scene<Decimal>& scene) {
    return convert_scene<double>(scene, [](const Decimal& number) { return number.to_double(); });
}

/// Without rounding. Throws std::domain_error for a number that to_rational refuses; parse_assignment rejects such
/// numbers.
Scene<Rational> rational_scene(const Scene<Decimal>& scene);

/// All its numbers belong to one field, which grows with each new root. Numbers of two scenes must not be mixed.
Scene<Certified> certified_scene(const Scene<Rational>& scene);

}  // namespace reference
