// The exact level of the certified kernel: the same stages over whole numbers. Lengths are multiplied by one power of
// two and directions by another, which changes no sign, so that doubles of any size become whole.
#pragma once

#include <gmpxx.h>

#include <compare>
#include <utility>
#include <vector>

#include "reference/kernel/ray.h"
#include "reference/stages/triangle.h"

namespace reference {

inline std::partial_ordering sign_of(const mpz_class& x) {
    return sgn(x) <=> 0;
}

}  // namespace reference

namespace reference::kernel {

/// A whole number of any size.
class Integer {
  public:
    Integer() = default;
    explicit Integer(int x) : value_(x) {}
    explicit Integer(mpz_class x) : value_(std::move(x)) {}
    const mpz_class& value() const { return value_; }

    Integer operator-() const { return Integer(mpz_class(-value_)); }
    friend Integer operator+(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ + y.value_)); }
    friend Integer operator-(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ - y.value_)); }
    friend Integer operator*(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ * y.value_)); }
    Integer& operator+=(const Integer& y) { return *this = *this + y; }
    Integer& operator-=(const Integer& y) { return *this = *this - y; }
    friend std::partial_ordering sign_of(const Integer& x) { return sgn(x.value_) <=> 0; }

  private:
    mpz_class value_;
};

/// A ray and objects in whole numbers, of a common scale: their t's can be compared.
struct IntegerScene {
    Ray<Integer> ray;
    std::vector<Sphere<Integer>> spheres;
    std::vector<Triangle<Integer>> triangles;
    long t_exponent = 0;  ///< the true t is that of the whole numbers times 2^t_exponent
};

/// All numbers are finite.
IntegerScene as_integers(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                         const std::vector<Triangle<double>>& triangles);

Quadratic<Integer> quadratic_of(const Ray<Integer>& ray, const Sphere<Integer>& sphere);
CramerSolution<Integer> solution_of(const Ray<Integer>& ray, const Triangle<Integer>& triangle);

}  // namespace reference::kernel
