// Ray and triangle without a wrong decision, by the same three levels as ray and sphere.
#pragma once

#include "reference/kernel/ray.h"
#include "reference/stages/triangle.h"

namespace reference::kernel {

/// Exact; an edge that two triangles share is never missed between them. Never over- or underflows.
TriangleResult decide(const Ray<double>& ray, const Triangle<double>& triangle);

/// decide(), with t, u and v.
TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle);

inline TriangleResult decide(const Ray<float>& ray, const Triangle<float>& triangle) {
    return decide(as_double(ray), as_double(triangle));
}
inline TriangleHit intersect(const Ray<float>& ray, const Triangle<float>& triangle) {
    return intersect(as_double(ray), as_double(triangle));
}

}  // namespace reference::kernel
