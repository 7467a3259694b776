// The hard cases with numbers near a decision, by id. Every input is a float32. Expected results
// were found by hand or in exact fractions, and hold to the digits quoted.
#pragma once

#include <string_view>
#include <vector>

#include "reference/kernel/first.h"

namespace hard_cases {

struct SphereCase {
    std::string_view id;
    reference::kernel::Ray<double> ray;
    reference::Sphere<double> sphere;
    reference::kernel::SphereResult result;
    std::string_view t = "0";  ///< for a hit or tangent, to the digits quoted
};

struct TriangleCase {
    std::string_view id;
    reference::kernel::Ray<double> ray;
    reference::Triangle<double> triangle;
    reference::kernel::TriangleResult result;
    std::string_view t = "0", u = "0", v = "0";  ///< "" if no value is quoted
};

std::vector<SphereCase> sphere_cases();
std::vector<TriangleCase> triangle_cases();

}  // namespace hard_cases
