#include "reference/kernel/integers.h"

#include <algorithm>

namespace reference::kernel {

void Scale::cover(double x) {
    if (x == 0) return;
    int above = 0;
    std::frexp(x, &above);
    least_ = std::min(least_, above - mantissa_bits);
    most_ = std::max(most_, above);
}

void Scale::cover(const Vec3<double>& p) {
    cover(p.x);
    cover(p.y);
    cover(p.z);
}

Scales scales_of(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                 const std::vector<Triangle<double>>& triangles) {
    Scales scales;
    scales.directions.cover(ray.direction);
    scales.lengths.cover(ray.origin);
    for (const Sphere<double>& sphere : spheres) {
        scales.lengths.cover(sphere.center);
        scales.lengths.cover(sphere.radius);
    }
    for (const Triangle<double>& triangle : triangles) {
        for (const Vec3<double>& vertex : {triangle.A, triangle.B, triangle.C}) scales.lengths.cover(vertex);
    }
    return scales;
}

}  // namespace reference::kernel
