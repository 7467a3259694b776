#include "reference/kernel/cylinder.h"

#include "reference/kernel/exact.h"
#include "reference/kernel/sphere.h"
#include "reference/numbers/interval.h"
#include "reference/stages/cylinder.h"

namespace reference::kernel {
namespace {

using Part = reference::CylinderPart;

bool is_valid(const Cylinder<double>& cylinder) {
    return is_finite(cylinder.center) && std::isfinite(cylinder.radius) && cylinder.radius > 0 &&
           std::isfinite(cylinder.height) && cylinder.height > 0;
}

/// cylinder_equations() with both sides of the caps' doubled: a Dyadic has no division.
template <class S>
CylinderEquations<S> equations_over(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const Vec3<S> start = over<S>(ray.origin) - over<S>(cylinder.center);
    const Vec3<S> V = over<S>(ray.direction);
    const S radius(cylinder.radius);
    const S height(cylinder.height);
    const S a = V.x * V.x + V.z * V.z;
    const S b = S(2) * (V.x * start.x + V.z * start.z);
    const S c = start.x * start.x + start.z * start.z - radius * radius;
    const S down = -(start.y + start.y);
    const S pace = V.y + V.y;
    return {{a, b, c, b * b - S(4) * a * c}, {down + height, pace}, {down - height, pace}};
}

template <class S>
struct Decision {
    CylinderEquations<S> equations;
    Part part;

    Decision(const Ray<double>& ray, const Cylinder<double>& cylinder)
        : equations(equations_over<S>(ray, cylinder)), part(hit_part(equations, Boundary::nonnegative)) {}

    bool is_on_tube() const { return part == Part::tube_smaller_root || part == Part::tube_larger_root; }
    CylinderResult result() const {
        if (part == Part::miss) return CylinderResult::miss;
        return is_on_tube() && sign_of(equations.tube.d) == 0 ? CylinderResult::tangent : CylinderResult::hit;
    }
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
    const CylinderPart part = exact.is_on_tube()            ? CylinderPart::tube
                              : exact.part == Part::top_cap ? CylinderPart::top
                                                            : CylinderPart::bottom;
    // But for rays that only touch the rim where they leave the tube, a tube's hit is that of the circle from above.
    const Quadratic<Dyadic>& tube = exact.equations.tube;
    const bool is_circle_hit = exact.is_on_tube() && tube_root(exact.part) == choose_root(tube, Boundary::nonnegative);
    const double t = is_circle_hit ? intersect(from_above(ray), from_above(cylinder)).t
                                   : nearest(*hit_parameter(exact.equations, exact.part));
    return {exact.result(), part, t};
}

}  // namespace reference::kernel
