// Ray and sphere without a wrong decision: a static error filter on plain doubles, double-double where that cannot
// tell, and whole numbers where that cannot either.
#pragma once

#include "reference/kernel/ray.h"
#include "reference/stages/sphere.h"

namespace reference::kernel {

/// Exact. Throws nothing, never over- or underflows.
SphereResult decide(const Ray<double>& ray, const Sphere<double>& sphere);

/// decide(), with t.
SphereHit intersect(const Ray<double>& ray, const Sphere<double>& sphere);

inline SphereResult decide(const Ray<float>& ray, const Sphere<float>& sphere) {
    return decide(as_double(ray), as_double(sphere));
}
inline SphereHit intersect(const Ray<float>& ray, const Sphere<float>& sphere) {
    return intersect(as_double(ray), as_double(sphere));
}

}  // namespace reference::kernel
