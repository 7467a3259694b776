// Rays and cylinders in exact fractions, most of them on a decision's edge or 2⁻⁴⁰ or 2⁻⁸⁰ beside it.
#pragma once

#include <cstdint>

#include "reference/numbers/rational.h"
#include "reference/stages/cylinder.h"

struct CylinderCase {
    reference::Vec3<reference::Rational> start, direction;  ///< a direction is not zero and not normalized
    reference::Cylinder<reference::Rational> cylinder;
};

/// Aims at a rim, the tube, a cap, the inside or anywhere; along any direction, horizontally, vertically or along the
/// tube's tangent; from before, in or behind the aim; at scales from 2⁻⁶⁰ to 2⁶⁰. The seeds from 0 on take turns in
/// all that.
CylinderCase cylinder_case(std::uint64_t seed);
