// How near a computed number is to the true one.
#pragma once

#include <cmath>

#include "reference/accuracy/rays/truth.h"

namespace reference::accuracy::truth {

/// Whether `given` lies within one unit in its last place of the truth.
inline bool is_within_one_ulp(double given, const Real& truth) {
    const double below = std::nextafter(given, -HUGE_VAL);
    const double above = std::nextafter(given, HUGE_VAL);
    if (std::isinf(given)) return truth > Real(below);
    const bool above_below = std::isinf(below) || Real(below) <= truth;
    return above_below && (std::isinf(above) || truth <= Real(above));
}

}  // namespace reference::accuracy::truth
