// What a ray hits first of a cylinder, in exact fractions and part by part as the handout of 2024 words it. It shares
// no formula with the stages: every t is a number of its own, and all of them are compared.
#pragma once

#include <optional>
#include <vector>

#include "reference/numbers/rational.h"
#include "reference/stages/cylinder.h"
#include "tests/reference/stages/surd.h"

namespace truth {

using reference::Rational;
using Point = reference::Vec3<Rational>;

/// The direction is not zero and not normalized.
struct Ray {
    Point start;
    Point direction;
};

struct CylinderHit {
    reference::CylinderPart part;
    Surd t;
    bool is_tangent = false;
    bool is_at_rim = false;
};

/// Empty for a miss.
std::optional<CylinderHit> hit(const Ray& ray, const reference::Cylinder<Rational>& cylinder,
                               reference::Boundary boundary);

}  // namespace truth
