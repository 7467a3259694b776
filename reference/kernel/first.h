// Which of a scene's objects a ray hits first, without a wrong decision.
#pragma once

#include <vector>

#include "reference/kernel/ray.h"

namespace reference::kernel {

/// The object hit at the smallest t >= 0.
struct First {
    enum class Kind {
        sphere,
        triangle,
        tie,      ///< two objects or more are hit at the same t exactly, and none before them
        none,     ///< nothing is hit
        invalid,  ///< the ray or one of the objects is invalid
    };
    Kind kind;
    std::size_t index;  ///< among the spheres or the triangles; 0 for tie, none and invalid
};

struct Cast {
    std::vector<SphereHit> spheres;
    std::vector<TriangleHit> triangles;
    First first;
};

/// Every object on its own, and the first of them. Writes into `result`, whose memory it keeps from ray to ray.
void cast_ray(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
              const std::vector<Triangle<double>>& triangles, Cast& result);

}  // namespace reference::kernel
