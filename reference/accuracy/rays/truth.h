// The truth about one ray, computed in rationals by formulas that differ from the kernel's. It uses only data types of
// the reference. Slow, but simple enough to be checked by reading.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <optional>

#include "reference/kernel/first.h"

namespace reference::accuracy::truth {

using Rational = boost::multiprecision::mpq_rational;
/// 1,000 digits: enough for doubles whose sizes differ by all of their range.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<1000>>;
using reference::Sphere;
using reference::Triangle;
using reference::Vec3;
using reference::kernel::Ray;
using reference::kernel::SphereResult;
using reference::kernel::TriangleResult;

struct Point {
    Rational x, y, z;
};
Point exact(const Vec3<double>& p);
Rational dot(const Point& p, const Point& q);

/// The ray's points on the sphere solve a t² + 2 h t + c = 0.
struct SphereTruth {
    SphereResult result;
    Rational a, h, c;
    /// For a hit or tangent: whether t is the smaller root.
    bool smaller = true;
    Real t() const;
};
SphereTruth sphere(const Ray<double>& ray, const Sphere<double>& sphere);

/// From the plane's normal and the Gram matrix of the edges.
struct TriangleTruth {
    TriangleResult result;
    Rational t, u, v;
};
TriangleTruth triangle(const Ray<double>& ray, const Triangle<double>& triangle);

/// The sign of (the sphere's t) - t, for a sphere that is hit.
int order(const SphereTruth& sphere, const Rational& t);

Real real(const Rational& x);

}  // namespace reference::accuracy::truth
