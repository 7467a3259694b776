// The truth about one ray, as an answer.
#pragma once

#include "reference/accuracy/rays/distributions.h"
#include "reference/accuracy/rays/hit.h"

namespace reference::accuracy {

/// t to 106 bits, as an unevaluated sum, so that even a double's error is seen.
struct TrueAnswer {
    Outcome outcome = Outcome::miss;
    double t = 0;
    double t_rest = 0;
};

/// t >= 0 is a hit, and a tangent ray touches the sphere. A ray misses a triangle without area, and a triangle in whose
/// plane it lies.
TrueAnswer true_answer(const SphereCase& c);
TrueAnswer true_answer(const TriangleCase& c);
TrueAnswer true_answer(const OrderCase& c);

}  // namespace reference::accuracy
