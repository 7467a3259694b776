#include "reference/kernel/sphere.h"

#include "reference/stages/sphere.h"

namespace reference::kernel {
namespace {

Quadratic<Dyadic> exact_quadratic(const Ray<double>& ray, const Sphere<double>& sphere) {
    return sphere_quadratic(over<Dyadic>(ray.origin), over<Dyadic>(ray.direction), over<Dyadic>(sphere));
}

}  // namespace

SphereResult decide_exactly(const Ray<double>& ray, const Sphere<double>& sphere) {
    const bool valid_sphere = is_finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
    if (!is_valid(ray) || !valid_sphere) return SphereResult::invalid;
    const Quadratic<Dyadic> quadratic = exact_quadratic(ray, sphere);
    if (choose_root(quadratic, Boundary::nonnegative) == RootChoice::miss) return SphereResult::miss;
    return sign_of(quadratic.d) == 0 ? SphereResult::tangent : SphereResult::hit;
}

HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Sphere<double>& sphere) {
    const Quadratic<Dyadic> quadratic = exact_quadratic(ray, sphere);
    return QuadraticRoot<Dyadic>{quadratic, choose_root(quadratic, Boundary::nonnegative)};
}

SphereHit intersect(const Ray<double>& ray, const Sphere<double>& sphere) {
    const SphereResult result = decide(ray, sphere);
    return {result, is_hit(result) ? nearest(exact_t(ray, sphere)) : 0};
}

}  // namespace reference::kernel
