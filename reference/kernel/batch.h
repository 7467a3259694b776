// Many rays at one object, coordinate by coordinate: the first level of the kernel in the machine's vectors, the rays
// that it leaves open one by one. Every result is the one that sphere.h and triangle.h give for its ray.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "reference/kernel/ray.h"

namespace reference::kernel {

/// Six columns of one length: ray i has the numbers at i.
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

/// decide() of each ray; `results` has the rays' size.
void decide(const Rays<float>& rays, const Sphere<float>& sphere, std::span<SphereResult> results);
void decide(const Rays<double>& rays, const Sphere<double>& sphere, std::span<SphereResult> results);
void decide(const Rays<float>& rays, const Triangle<float>& triangle, std::span<TriangleResult> results);
void decide(const Rays<double>& rays, const Triangle<double>& triangle, std::span<TriangleResult> results);

/// intersect_to_float() of each ray; `results` and `t` have the rays' size.
void intersect_to_float(const Rays<float>& rays, const Sphere<float>& sphere, std::span<SphereResult> results,
                        std::span<double> t);
void intersect_to_float(const Rays<double>& rays, const Sphere<double>& sphere, std::span<SphereResult> results,
                        std::span<double> t);
void intersect_to_float(const Rays<float>& rays, const Triangle<float>& triangle, std::span<TriangleResult> results,
                        std::span<double> t);
void intersect_to_float(const Rays<double>& rays, const Triangle<double>& triangle, std::span<TriangleResult> results,
                        std::span<double> t);

}  // namespace reference::kernel
