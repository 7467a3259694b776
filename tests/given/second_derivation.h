// The truth once more, by other formulas in other arithmetic: GMP's whole numbers, the point of the ray that is nearest
// to the sphere's centre, and the volumes that the ray spans with a triangle's edges. Shares no code with the
// fractions.
#pragma once

#include <gmpxx.h>

#include "reference/kernel/ray.h"

namespace second_derivation {

using reference::Sphere;
using reference::Triangle;
using reference::kernel::Ray;
using reference::kernel::SphereResult;
using reference::kernel::TriangleResult;

SphereResult decide(const Ray<double>& ray, const Sphere<double>& sphere);

/// For a ray that meets the sphere: its first t >= 0 lies in [lo, hi]. Ends that touch it count as in.
bool is_first_t_within(const Ray<double>& ray, const Sphere<double>& sphere, const mpq_class& lo, const mpq_class& hi);

struct TriangleSolution {
    TriangleResult result;
    mpq_class t, u, v;  ///< where the ray crosses the plane
};
TriangleSolution solve(const Ray<double>& ray, const Triangle<double>& triangle);

}  // namespace second_derivation
