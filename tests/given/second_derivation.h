// A second, independent derivation of the truth, in GMP's integers. For a sphere it uses the point of the ray nearest
// to the centre, for a triangle the volumes that the ray spans with the edges. It shares no code with the fractions.
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

/// Whether the first t >= 0 of a ray that meets the sphere lies in the closed interval [lo, hi].
bool is_first_t_within(const Ray<double>& ray, const Sphere<double>& sphere, const mpq_class& lo, const mpq_class& hi);

struct TriangleSolution {
    TriangleResult result;
    mpq_class t, u, v;  ///< where the ray crosses the plane
};
TriangleSolution solve(const Ray<double>& ray, const Triangle<double>& triangle);

}  // namespace second_derivation
