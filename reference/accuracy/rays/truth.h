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
Real real(const Rational& x);

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

/// x + y√d with d >= 0.
struct Surd {
    Rational x, y = 0, d = 0;

    Real value() const { return real(x) + real(y) * sqrt(real(d)); }
};
int sign(const Surd& number);

/// The handout's words: the top cap, the bottom cap and the tube are each hit or not, and the smallest t counts.
struct CylinderTruth {
    Surd t;
    kernel::CylinderPart part;
    bool is_tangent;
    bool is_at_rim;  ///< on a cap's edge, of a ray that is not level
};
struct ExactCylinder {
    Point center;
    Rational radius, height;
};
ExactCylinder exact(const Cylinder<double>& cylinder);
/// Of the ray S + tV; empty for a miss.
std::optional<CylinderTruth> cylinder(const Point& S, const Point& V, const ExactCylinder& cylinder, Boundary boundary);
std::optional<CylinderTruth> cylinder(const Ray<double>& ray, const Cylinder<double>& cylinder,
                                      Boundary boundary = Boundary::nonnegative);

/// The sign of (the sphere's t) - t, for a sphere that is hit.
int order(const SphereTruth& sphere, const Rational& t);

}  // namespace reference::accuracy::truth
