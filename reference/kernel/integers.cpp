#include "reference/kernel/integers.h"

#include <algorithm>
#include <limits>

namespace reference::kernel {
namespace {

/// The power of two below which no number of a set has a bit.
class Scale {
  public:
    void cover(double x) {
        if (x == 0) return;
        int exponent = 0;
        std::frexp(x, &exponent);
        least_ = std::min(least_, exponent - std::numeric_limits<double>::digits);
    }
    void cover(const Vec3<double>& p) {
        cover(p.x);
        cover(p.y);
        cover(p.z);
    }
    Integer operator()(double x) const {
        if (x == 0) return Integer(0);
        int exponent = 0;
        const double mantissa = std::ldexp(std::frexp(x, &exponent), std::numeric_limits<double>::digits);
        mpz_class whole(mantissa);
        whole <<= static_cast<mp_bitcnt_t>(exponent - std::numeric_limits<double>::digits - least_);
        return Integer(whole);
    }
    Vec3<Integer> operator()(const Vec3<double>& p) const { return {(*this)(p.x), (*this)(p.y), (*this)(p.z)}; }

    /// 0 for a set of zeros.
    int exponent() const { return least_ == std::numeric_limits<int>::max() ? 0 : least_; }

  private:
    int least_ = std::numeric_limits<int>::max();
};

}  // namespace

IntegerScene as_integers(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                         const std::vector<Triangle<double>>& triangles) {
    Scale directions;
    directions.cover(ray.direction);
    Scale lengths;
    lengths.cover(ray.origin);
    for (const Sphere<double>& sphere : spheres) {
        lengths.cover(sphere.center);
        lengths.cover(sphere.radius);
    }
    for (const Triangle<double>& triangle : triangles) {
        for (const Vec3<double>& vertex : {triangle.A, triangle.B, triangle.C}) lengths.cover(vertex);
    }
    IntegerScene scene{
        {lengths(ray.origin), directions(ray.direction)}, {}, {}, long{lengths.exponent()} - directions.exponent()};
    for (const Sphere<double>& sphere : spheres) {
        scene.spheres.push_back({lengths(sphere.center), lengths(sphere.radius)});
    }
    for (const Triangle<double>& triangle : triangles) {
        scene.triangles.push_back({lengths(triangle.A), lengths(triangle.B), lengths(triangle.C)});
    }
    return scene;
}

Quadratic<Integer> quadratic_of(const Ray<Integer>& ray, const Sphere<Integer>& sphere) {
    return sphere_quadratic(ray.origin, ray.direction, sphere);
}

CramerSolution<Integer> solution_of(const Ray<Integer>& ray, const Triangle<Integer>& triangle) {
    return solve_by_cramer(triangle_system(ray.origin, ray.direction, triangle));
}

}  // namespace reference::kernel
