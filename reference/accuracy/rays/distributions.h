// Random rays near the decisions that a kernel gets wrong. Every function maps one seed to one case, so that a failure
// can be repeated from RapidCheck's output.
#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>
#include <vector>

#include "reference/accuracy/rays/hit.h"
#include "reference/accuracy/rays/random_numbers.h"

namespace reference::accuracy {

template <class T>
struct SphereProblem {
    Ray<T> ray;
    Sphere<T> sphere;
};
template <class T>
struct TriangleProblem {
    Ray<T> ray;
    Triangle<T> triangle;
};
template <class T>
struct CylinderProblem {
    Ray<T> ray;
    Cylinder<T> cylinder;
};
template <class T>
struct OrderProblem {
    Ray<T> ray;
    Sphere<T> sphere;
    Triangle<T> triangle;
};
using SphereCase = SphereProblem<double>;
using TriangleCase = TriangleProblem<double>;
using CylinderCase = CylinderProblem<double>;
using OrderCase = OrderProblem<double>;

/// Whether the cases exist in floats as well; those about the steps or the range of doubles don't.
enum class Exists { in_floats, in_doubles_only };

template <class Case>
struct Distribution {
    std::string_view name;
    Case (*draw)(std::uint64_t seed, Inputs inputs);
    Exists exists = Exists::in_floats;
    bool hard = true;  ///< aims at what rounding gets wrong

    Case make(std::uint64_t seed) const { return draw(seed, Inputs::mixed); }
    /// Every number is a float. Only for a distribution that exists in floats.
    Case make_in_floats(std::uint64_t seed) const { return draw(seed, Inputs::floats); }

    friend void PrintTo(const Distribution& distribution, std::ostream* out) { *out << distribution.name; }
};

std::vector<Distribution<SphereCase>> sphere_distributions();
std::vector<Distribution<TriangleCase>> triangle_distributions();
std::vector<Distribution<CylinderCase>> cylinder_distributions();
std::vector<Distribution<OrderCase>> order_distributions();

/// The truth, in rationals. t >= 0 is a hit, and a tangent ray touches the sphere. A ray misses a triangle without
/// area, and a triangle in whose plane it lies.
Answer true_answer(const SphereCase& c);
Answer true_answer(const TriangleCase& c);
Answer true_answer(const CylinderCase& c);
Answer true_answer(const OrderCase& c);

}  // namespace reference::accuracy
