// The exact level of the certified kernel: the same stages over whole numbers. Lengths are multiplied by one power of
// two and directions by another, which changes no sign, so that doubles of any size become whole.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/kernel/ray.h"
#include "reference/kernel/whole.h"
#include "reference/stages/triangle.h"

namespace reference::kernel {

/// The range of the bits that a set of finite doubles has.
class Scale {
  public:
    void cover(double x);
    void cover(const Vec3<double>& p);
    /// The numbers times 2^-exponent() are whole and have at most bits() bits.
    int exponent() const { return is_empty() ? 0 : least_; }
    int bits() const { return is_empty() ? 0 : most_ - least_; }

    template <class I>
    I whole(double x) const {
        if (x == 0) return I(0);
        int above = 0;
        const double mantissa = std::ldexp(std::frexp(x, &above), mantissa_bits);
        return I(static_cast<std::int64_t>(mantissa), static_cast<unsigned>(above - mantissa_bits - least_));
    }
    template <class I>
    Vec3<I> whole(const Vec3<double>& p) const {
        return Vec3<I>(whole<I>(p.x), whole<I>(p.y), whole<I>(p.z));
    }

  private:
    static constexpr int mantissa_bits = 53;
    bool is_empty() const { return least_ > most_; }
    int least_ = 1 << 20;
    int most_ = -(1 << 20);
};

struct Scales {
    Scale lengths;
    Scale directions;
};
/// All numbers are finite.
Scales scales_of(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                 const std::vector<Triangle<double>>& triangles);

/// A ray and objects in whole numbers, of a common scale: their t's can be compared.
template <class I>
struct IntegerScene {
    Ray<I> ray;
    std::vector<Sphere<I>> spheres;
    std::vector<Triangle<I>> triangles;
    long t_exponent = 0;  ///< the true t is that of the whole numbers times 2^t_exponent
};

template <class I>
IntegerScene<I> as_integers(const Scales& scales, const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                            const std::vector<Triangle<double>>& triangles) {
    const Scale& lengths = scales.lengths;
    const auto length = [&](const Vec3<double>& p) { return lengths.template whole<I>(p); };
    IntegerScene<I> scene{{length(ray.origin), scales.directions.template whole<I>(ray.direction)},
                          {},
                          {},
                          long{lengths.exponent()} - scales.directions.exponent()};
    for (const Sphere<double>& sphere : spheres) {
        scene.spheres.push_back({length(sphere.center), lengths.template whole<I>(sphere.radius)});
    }
    for (const Triangle<double>& triangle : triangles) {
        scene.triangles.push_back({length(triangle.A), length(triangle.B), length(triangle.C)});
    }
    return scene;
}

/// The bits of the longest polynomials of order.h, with L bits a length and V a direction. aN²: a has 2V + 2 bits, N
/// three products of differences, 3L + 6, and the three summands of P two bits more: 2V + 6L + 16. Two spheres: d has
/// 2V + 2L + 9, and (d + e - x²)² 4V + 4L + 24.
inline int polynomial_bits(const Scales& scales) {
    const int V = scales.directions.bits();
    const int L = scales.lengths.bits();
    return std::max(2 * V + 6 * L + 16, 4 * V + 4 * L + 24);
}

/// Calls `decide` with the scene in integers that hold every polynomial of the stages.
template <class Decide>
auto in_integers(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                 const std::vector<Triangle<double>>& triangles, Decide decide) {
    const Scales scales = scales_of(ray, spheres, triangles);
    if (polynomial_bits(scales) <= wide_bits) {
        return decide(as_integers<WideInteger>(scales, ray, spheres, triangles));
    }
    return decide(as_integers<Integer>(scales, ray, spheres, triangles));
}

template <class I>
Quadratic<I> quadratic_of(const Ray<I>& ray, const Sphere<I>& sphere) {
    return sphere_quadratic(ray.origin, ray.direction, sphere);
}

template <class I>
CramerSolution<I> solution_of(const Ray<I>& ray, const Triangle<I>& triangle) {
    return solve_by_cramer(triangle_system(ray.origin, ray.direction, triangle));
}

}  // namespace reference::kernel
