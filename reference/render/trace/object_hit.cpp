#include "reference/render/trace/object_hit.h"

#include <cmath>

#include "reference/kernel/order.h"
#include "reference/render/trace/exact_ray.h"
#include "reference/stages/triangle.h"

namespace reference::render {
namespace {

struct SphereForm {
    Quadratic<Dyadic> quadratic;
    RootChoice choice;
};

template <class AnyRay>
SphereForm sphere_form(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    Quadratic<Dyadic> quadratic =
        sphere_quadratic(exact_start(scene, ray), exact(ray.ray.direction), exact(scene.spheres[object]));
    if (!is_own(ray, object)) return {quadratic, choose_root(quadratic, boundary_of(scene, ray))};
    quadratic.c = Dyadic();
    quadratic.d = quadratic.b * quadratic.b;
    return {quadratic, RootChoice::larger};
}

template <class AnyRay>
CramerSolution<Dyadic> triangle_form(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    return solve_by_cramer(
        triangle_system(exact_start(scene, ray), exact(ray.ray.direction), exact(scene.triangle(object).triangle)));
}

/// Computed without cancellation.
double root_in_doubles(const SphereForm& form) {
    const double a = form.quadratic.a.as_double();
    const double b = form.quadratic.b.as_double();
    const double c = form.quadratic.c.as_double();
    const double spread = std::sqrt(form.quadratic.d.as_double());
    if (form.choice == RootChoice::smaller) return c == 0 ? 0 : 2 * c / (spread - b);
    if (b < 0) return (spread - b) / (2 * a);
    return c == 0 ? 0 : -2 * c / (spread + b);
}

template <class AnyRay>
ObjectHit exact_sphere_hit(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    const SphereForm form = sphere_form(scene, ray, object);
    if (form.choice == RootChoice::miss) return {};
    // If the ray starts on the sphere, a hit at t > 0 is reached through the inside.
    const auto c = sign_of(form.quadratic.c);
    const bool crosses = sign_of(form.quadratic.b) < 0 && form.choice == RootChoice::larger;
    return {true, c < 0 || (c == 0 && crosses), root_in_doubles(form)};
}

/// Whether t would be beyond the farthest point of the triangle: with s = S - A and e = |B-A|₁ + |C-A|₁ a hit has t|V|₁
/// <= |s|₁ + e, so |T| |V|₁ <= det (|s|₁ + e).
template <class AnyRay>
bool is_far_beside(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    using Prepared = kernel::PreparedTriangle<double>;
    const Prepared& triangle = scene.triangle(object);
    kernel::TriangleFilter filter(ray.ray, triangle);
    allow_for_start(filter, ray, triangle.edges);
    const double n = Prepared::norm(ray.ray.origin - triangle.A) + triangle.edges + uncertainty_of(ray);
    const double T = std::abs(filter.t_numerator) - filter.t_error;
    return T * Prepared::norm(ray.ray.direction) > (filter.det + filter.error) * n * (1 + 0x1p-40);
}

template <class AnyRay>
ObjectHit exact_triangle_hit(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    if (is_far_beside(scene, ray, object)) return {};
    const CramerSolution<Dyadic> form = triangle_form(scene, ray, object);
    const TriangleHit result = classify(form);
    const bool at_start = result == TriangleHit::boundary && boundary_of(scene, ray) == Boundary::nonnegative;
    if (at_start) return {true, false, 0};
    if (result != TriangleHit::hit) return {};
    return {true, false, form.t_numerator.as_double() / form.det.as_double()};
}

/// t of an object that is hit.
template <class AnyRay>
kernel::ExactT<Dyadic> exact_t(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: {
            const auto [quadratic, choice] = sphere_form(scene, ray, object);
            const kernel::HalfQuadratic half{quadratic.a, quadratic.b * Dyadic(0.5), quadratic.c};
            return kernel::Root{half, choice == RootChoice::smaller};
        }
        case ObjectKind::triangle: {
            const CramerSolution<Dyadic> form = triangle_form(scene, ray, object);
            return kernel::Fraction{form.t_numerator, form.det};
        }
        case ObjectKind::cylinder: break;
    }
    return exact_cylinder_t(scene, ray, object);
}

/// Whether an object that is hit is hit at t < 1.
template <class AnyRay>
bool is_before_one(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    const kernel::ExactT<Dyadic> end = kernel::Fraction{Dyadic(1), Dyadic(1)};
    return order(exact_t(scene, ray, object), end) < 0;
}

}  // namespace

ObjectHit exact_hit(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object) {
    if (scene.kind_of(object) == ObjectKind::triangle) {
        const bool counts_start = scene.boundary == Boundary::nonnegative;
        const kernel::TriangleHit hit = kernel::intersect(ray.ray, scene.triangle(object).triangle);
        return {hit.result == kernel::TriangleResult::hit && (hit.t > 0 || counts_start), false, hit.t};
    }
    const Sphere<double>& sphere = scene.spheres[object];
    const kernel::SphereHit hit = kernel::intersect(ray.ray, sphere);
    if (hit.result == kernel::SphereResult::miss) return {};
    const kernel::SphereFilter filter(ray.ray, sphere);
    // If the ray starts on or near the sphere, exact numbers decide which root counts and from which side.
    if (!(std::abs(filter.c) > 0x1p-48 * filter.m)) return exact_sphere_hit(scene, ray, object);
    return {true, filter.c < 0, hit.t};
}
ObjectHit exact_hit(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object) {
    return scene.kind_of(object) == ObjectKind::triangle ? exact_triangle_hit(scene, ray, object)
                                                         : exact_sphere_hit(scene, ray, object);
}

std::partial_ordering order_exactly(const PreparedScene& scene, const CameraRay& ray, std::uint32_t one,
                                    std::uint32_t other) {
    return order(exact_t(scene, ray, one), exact_t(scene, ray, other));
}
std::partial_ordering order_exactly(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t one,
                                    std::uint32_t other) {
    return order(exact_t(scene, ray, one), exact_t(scene, ray, other));
}

bool is_hit_before_end(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object) {
    return is_before_one(scene, ray, object);
}
bool is_hit_before_end(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object) {
    return is_before_one(scene, ray, object);
}

}  // namespace reference::render
