// The catalog of hard cases: rays and cameras whose answers are near a decision. Their numbers are floats, so that
// programs in float and in double get the same input; those of the cases D1 to D5 and C14 are doubles. The expected
// answers were found by hand or in exact fractions. `raygrade stress` shows the list, and the tests run it.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "reference/kernel/first.h"

namespace reference::hard_cases {

struct SphereAndTriangle {
    Sphere<double> sphere;
    Triangle<double> triangle;
};

/// The target of the ray; for a camera, the question is its X axis.
using Target = std::variant<Sphere<double>, Triangle<double>, Cylinder<double>, SphereAndTriangle, Camera<double>>;

struct Case {
    std::string_view id;      ///< "H12"
    std::string_view group;   ///< "far and small"
    kernel::Ray<double> ray;  ///< of a camera: all 0
    Target target;
    /// Of an object: hit, miss, tangent, coplanar, degenerate (no area) or invalid (an input is not finite, or a length
    /// is 0). Of two objects: sphere, triangle or tie. Of a camera: axis or invalid.
    std::string_view decision;
    /// To the digits quoted: t, and for some triangles u and v; or the axis. "" where none is quoted; empty without a
    /// hit.
    std::vector<std::string_view> numbers = {};
};

const std::vector<Case>& cases();

}  // namespace reference::hard_cases
