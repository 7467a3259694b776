// Tests many rays against one object. The rays are stored by coordinate, so that the filters run in vector
// instructions; rays that a filter leaves open are decided one by one. Every result equals that of sphere.h or
// triangle.h for the same ray.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "reference/kernel/ray.h"

namespace reference::kernel {

/// Six columns of equal length. Ray i consists of the numbers at index i.
template <class T>
struct Rays {
    std::array<std::span<const T>, 3> origin;
    std::array<std::span<const T>, 3> direction;

    std::size_t size() const { return origin[0].size(); }
    Ray<T> operator[](std::size_t i) const {
        return {Vec3<T>(origin[0][i], origin[1][i], origin[2][i]),
                Vec3<T>(direction[0][i], direction[1][i], direction[2][i])};
    }
};

/// Calls decide() for each ray; results.size() is rays.size().
void decide(const Rays<float>& rays, const Sphere<float>& sphere, std::span<SphereResult> results);
void decide(const Rays<double>& rays, const Sphere<double>& sphere, std::span<SphereResult> results);
void decide(const Rays<float>& rays, const Triangle<float>& triangle, std::span<TriangleResult> results);
void decide(const Rays<double>& rays, const Triangle<double>& triangle, std::span<TriangleResult> results);

/// Calls intersect_to_float() for each ray; `results` and `t` are as long as `rays`.
void intersect_to_float(const Rays<float>& rays, const Sphere<float>& sphere, std::span<SphereResult> results,
                        std::span<double> t);
void intersect_to_float(const Rays<double>& rays, const Sphere<double>& sphere, std::span<SphereResult> results,
                        std::span<double> t);
void intersect_to_float(const Rays<float>& rays, const Triangle<float>& triangle, std::span<TriangleResult> results,
                        std::span<double> t);
void intersect_to_float(const Rays<double>& rays, const Triangle<double>& triangle, std::span<TriangleResult> results,
                        std::span<double> t);

}  // namespace reference::kernel
