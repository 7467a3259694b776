// An assignment's scene with every number as the nearest double.
#pragma once

#include "reference/decimal.h"
#include "reference/scene.h"

namespace reference {

inline Scene<double> in_double(const Scene<Decimal>& scene) {
    return convert_scene<double>(scene, [](const Decimal& number) { return number.to_double(); });
}

}  // namespace reference
