// Random rays that aim at the decisions a kernel gets wrong. Every function maps one seed to one case, so that a
// failure can be repeated from what RapidCheck prints.
#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>
#include <vector>

#include "reference/kernel/ray.h"

namespace distributions {

using reference::kernel::Ray;

struct SphereCase {
    Ray<double> ray;
    reference::Sphere<double> sphere;
};
struct TriangleCase {
    Ray<double> ray;
    reference::Triangle<double> triangle;
};
struct SpherePairCase {
    Ray<double> ray;
    reference::Sphere<double> one;
    reference::Sphere<double> other;
};
struct OrderCase {
    Ray<double> ray;
    reference::Sphere<double> sphere;
    reference::Triangle<double> triangle;
};

template <class Case>
struct Distribution {
    std::string_view name;
    Case (*make)(std::uint64_t seed);

    friend void PrintTo(const Distribution& distribution, std::ostream* out) { *out << distribution.name; }
};

std::vector<Distribution<SphereCase>> spheres();
std::vector<Distribution<TriangleCase>> triangles();
std::vector<Distribution<OrderCase>> orders();
std::vector<Distribution<SpherePairCase>> sphere_pairs();

}  // namespace distributions
