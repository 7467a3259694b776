#include "reference/kernel/cylinder.h"

#include "reference/numbers/interval.h"

namespace reference::kernel {
namespace {

using Part = reference::CylinderPart;

bool is_valid(const Cylinder<double>& cylinder) {
    return is_finite(cylinder.center) && std::isfinite(cylinder.radius) && cylinder.radius > 0 &&
           std::isfinite(cylinder.height) && cylinder.height > 0;
}

template <class S>
struct Decision {
    CylinderEquations<S> equations;
    Part part;

    Decision(const Ray<double>& ray, const Cylinder<double>& cylinder)
        : equations(doubled_equations(over<S>(ray.origin), over<S>(ray.direction), over<S>(cylinder))),
          part(hit_part(equations, Boundary::nonnegative)) {}
};

}  // namespace

HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const Decision<Dyadic> exact(ray, cylinder);
    return *hit_parameter(exact.equations, exact.part);
}

CylinderHit intersect(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    if (!is_valid(ray) || !is_valid(cylinder)) return {CylinderResult::invalid, CylinderPart::tube, 0};
    if (Decision<Interval<double>>(ray, cylinder).part == Part::miss) {
        return {CylinderResult::miss, CylinderPart::tube, 0};
    }
    const Decision<Dyadic> exact(ray, cylinder);
    if (exact.part == Part::miss) return {CylinderResult::miss, CylinderPart::tube, 0};
    const bool is_on_tube = tube_root(exact.part) != RootChoice::miss;
    const CylinderPart part = is_on_tube                    ? CylinderPart::tube
                              : exact.part == Part::top_cap ? CylinderPart::top
                                                            : CylinderPart::bottom;
    const bool is_tangent = is_on_tube && sign_of(exact.equations.tube.d) == 0;
    return {is_tangent ? CylinderResult::tangent : CylinderResult::hit, part,
            nearest(*hit_parameter(exact.equations, exact.part))};
}

}  // namespace reference::kernel
