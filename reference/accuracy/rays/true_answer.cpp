#include "reference/accuracy/rays/true_answer.h"

#include "reference/accuracy/rays/truth.h"

namespace reference::accuracy {
namespace {

TrueAnswer at(Outcome outcome, const truth::Real& t) {
    const auto high = t.convert_to<double>();
    return {outcome, high, truth::Real(t - high).convert_to<double>()};
}

bool is_hit(const truth::SphereTruth& sphere) {
    return sphere.result == kernel::SphereResult::hit || sphere.result == kernel::SphereResult::tangent;
}

}  // namespace

TrueAnswer true_answer(const SphereCase& c) {
    const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
    return is_hit(sphere) ? at(Outcome::hit, sphere.t()) : TrueAnswer{};
}

TrueAnswer true_answer(const TriangleCase& c) {
    const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
    return triangle.result == kernel::TriangleResult::hit ? at(Outcome::hit, truth::real(triangle.t)) : TrueAnswer{};
}

TrueAnswer true_answer(const OrderCase& c) {
    const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
    const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
    const bool in_triangle = triangle.result == kernel::TriangleResult::hit;
    if (!is_hit(sphere) && !in_triangle) return {};
    if (!in_triangle) return at(Outcome::sphere_first, sphere.t());
    if (!is_hit(sphere)) return at(Outcome::triangle_first, truth::real(triangle.t));
    const int order = truth::order(sphere, triangle.t);
    if (order < 0) return at(Outcome::sphere_first, sphere.t());
    return at(order == 0 ? Outcome::tie : Outcome::triangle_first, truth::real(triangle.t));
}

}  // namespace reference::accuracy
