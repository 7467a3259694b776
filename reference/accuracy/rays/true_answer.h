// The truth about one ray in the shape of an answer.
#pragma once

#include "reference/accuracy/distributions.h"
#include "reference/accuracy/hit.h"

namespace reference::accuracy {

/// t to 106 bits, as an unevaluated sum, so that even a double's error is seen.
struct TrueAnswer {
    Outcome outcome = Outcome::miss;
    double t = 0;
    double t_rest = 0;
};

/// Closed: t >= 0 is a hit, a tangent touches. A triangle without an area, or one whose plane the ray lies in, is
/// missed.
TrueAnswer true_answer(const SphereCase& c);
TrueAnswer true_answer(const TriangleCase& c);
TrueAnswer true_answer(const OrderCase& c);

}  // namespace reference::accuracy
