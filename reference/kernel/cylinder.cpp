#include "reference/kernel/cylinder.h"

namespace reference::kernel {
namespace {

using Part = reference::CylinderPart;

CylinderEquations<Dyadic> exact_equations(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    return doubled_equations(over<Dyadic>(ray.origin), over<Dyadic>(ray.direction), over<Dyadic>(cylinder));
}

}  // namespace

HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const CylinderEquations<Dyadic> exact = exact_equations(ray, cylinder);
    return *hit_parameter(exact, hit_part(exact, Boundary::nonnegative));
}

CylinderHit intersect(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const CylinderFilter filter(ray, cylinder);
    if (filter.is_known && !filter.is_hit()) return {CylinderResult::miss, CylinderPart::tube, 0};
    const bool valid_cylinder = is_finite(cylinder.center) && std::isfinite(cylinder.radius) && cylinder.radius > 0 &&
                                std::isfinite(cylinder.height) && cylinder.height > 0;
    if (!is_valid(ray) || !valid_cylinder) return {CylinderResult::invalid, CylinderPart::tube, 0};
    const CylinderEquations<Dyadic> exact = exact_equations(ray, cylinder);
    const Part part = hit_part(exact, Boundary::nonnegative);
    if (part == Part::miss) return {CylinderResult::miss, CylinderPart::tube, 0};
    const bool is_on_tube = tube_root(part) != RootChoice::miss;
    const CylinderPart hit = is_on_tube              ? CylinderPart::tube
                             : part == Part::top_cap ? CylinderPart::top
                                                     : CylinderPart::bottom;
    const bool is_tangent = is_on_tube && sign_of(exact.tube.d) == 0;
    return {is_tangent ? CylinderResult::tangent : CylinderResult::hit, hit, nearest(*hit_parameter(exact, part))};
}

}  // namespace reference::kernel
