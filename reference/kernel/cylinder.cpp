#include "reference/kernel/cylinder.h"

#include "reference/kernel/integers.h"
#include "reference/kernel/sphere.h"
#include "reference/numbers/interval.h"

namespace reference::kernel {
namespace {

bool is_valid(const Cylinder<double>& cylinder) {
    return is_finite(cylinder.center) && std::isfinite(cylinder.radius) && cylinder.radius > 0 &&
           std::isfinite(cylinder.height) && cylinder.height > 0;
}

CylinderChoice choose(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    // Whether the ray meets the circle from above at all is known soonest.
    const SphereFilter circle(from_above(ray), from_above(cylinder));
    if (circle.is_known(1) && !circle.is_hit()) return {CylinderChoice::Kind::miss};
    using S = Interval<double>;
    const Vec3<S> start = over<S>(ray.origin) - over<S>(cylinder.center);
    const CylinderChoice choice = choose_crossing(
        cylinder_form(start, over<S>(ray.direction), S(cylinder.radius), S(cylinder.height)), Boundary::nonnegative);
    if (choice.kind != CylinderChoice::Kind::unsure) return choice;
    const Scales scales(ray, cylinder);
    return choose_crossing(cylinder_form_of(Whole<Integer>(scales), ray, cylinder), Boundary::nonnegative);
}

double t_of(const Ray<double>& ray, const Cylinder<double>& cylinder, Crossing::At at) {
    // Where a root is the hit, it is the circle's first root with t >= 0.
    if (at == Crossing::At::smaller_root || at == Crossing::At::larger_root) {
        return intersect(from_above(ray), from_above(cylinder)).t;
    }
    const Scales scales(ray, cylinder);
    const auto form = cylinder_form_of(Whole<Integer>(scales), ray, cylinder);
    return exact_quotient(form.caps[at == Crossing::At::first_cap ? 0 : 1], form.pace, scales.exponent_of_t());
}

}  // namespace

CylinderHit intersect(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    if (!is_valid(ray) || !is_valid(cylinder)) return {CylinderResult::invalid, CylinderPart::tube, 0};
    const CylinderChoice choice = choose(ray, cylinder);
    if (choice.kind == CylinderChoice::Kind::miss) return {CylinderResult::miss, CylinderPart::tube, 0};
    return {choice.is_tangent ? CylinderResult::tangent : CylinderResult::hit, choice.crossing.part,
            t_of(ray, cylinder, choice.crossing.at)};
}

}  // namespace reference::kernel
