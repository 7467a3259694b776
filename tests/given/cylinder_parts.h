// The truth about a ray and a cylinder, part by part in the handout's own words: the top cap, the bottom cap and the
// tube are each hit or not, and of all hits the smallest t counts. In fractions and numbers x + y√d of fractions. It
// shares no code and no formula with the kernel, which asks where the ray enters and leaves.
#pragma once

#include <optional>

#include "reference/accuracy/rays/truth.h"
#include "reference/kernel/cylinder.h"

namespace cylinder_parts {

using reference::Boundary;
using reference::Cylinder;
using reference::Sphere;
using reference::Triangle;
using reference::accuracy::truth::Point;
using reference::accuracy::truth::Rational;
using reference::accuracy::truth::Real;
using reference::kernel::CylinderPart;
using reference::kernel::Ray;

/// x + y√d with d >= 0.
struct Surd {
    Rational x, y = 0, d = 0;

    Real value() const;
};
int sign(const Surd& number);
/// The sign of one - other.
int order(const Surd& one, const Surd& other);

struct Hit {
    Surd t;
    CylinderPart part;
    bool is_tangent = false;
    bool is_at_rim = false;  ///< not of a level ray
};
struct ExactCylinder {
    Point center;
    Rational radius, height;
};
/// Of the ray S + tV. Empty for a miss.
std::optional<Hit> first_hit(const Point& S, const Point& V, const ExactCylinder& cylinder, Boundary boundary);
std::optional<Hit> first_hit(const Point& S, const Point& V, const Cylinder<double>& cylinder, Boundary boundary);
std::optional<Hit> first_hit(const Ray<double>& ray, const Cylinder<double>& cylinder, Boundary boundary);

/// The t of the first hit with t >= 0 with other objects, from their own truths.
std::optional<Surd> first_t(const Ray<double>& ray, const Sphere<double>& sphere);
std::optional<Surd> first_t(const Ray<double>& ray, const Triangle<double>& triangle);
std::optional<Surd> first_t(const Ray<double>& ray, const Cylinder<double>& cylinder);

}  // namespace cylinder_parts
