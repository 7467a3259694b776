#include "reference/render/object_hit.h"

#include <cmath>

#include "reference/kernel/order.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "reference/render/cylinder_hit.h"
#include "reference/render/exact_ray.h"
#include "reference/stages/triangle.h"

namespace reference::render {
namespace {

struct SphereForm {
    Quadratic<Dyadic> quadratic;
    RootChoice choice;
};

SphereForm sphere_form(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    Quadratic<Dyadic> quadratic =
        sphere_quadratic(exact_start(scene, ray), exact(ray.ray.direction), exact(scene.spheres[object]));
    if (!ray.starts_on(object)) return {quadratic, choose_root(quadratic, ray.boundary(scene))};
    quadratic.c = Dyadic();
    quadratic.d = quadratic.b * quadratic.b;
    return {quadratic, RootChoice::larger};
}

CramerSolution<Dyadic> triangle_form(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
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

Hit exact_sphere_hit(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    if (!ray.start) {
        const kernel::SphereHit hit = kernel::intersect(ray.ray, scene.spheres[object]);
        if (hit.result == kernel::SphereResult::miss) return {};
        const kernel::SphereFilter filter(ray.ray, scene.spheres[object]);
        // If the ray starts on or near the sphere, exact numbers decide which root counts and from which side.
        if (std::abs(filter.c) > 0x1p-48 * filter.m) return {hit.t, object, filter.c < 0};
    }
    const SphereForm form = sphere_form(scene, ray, object);
    if (form.choice == RootChoice::miss) return {};
    // If the ray starts on the sphere, a hit at t > 0 is reached through the inside.
    const auto c = sign_of(form.quadratic.c);
    const bool crosses = sign_of(form.quadratic.b) < 0 && form.choice == RootChoice::larger;
    return {root_in_doubles(form), object, c < 0 || (c == 0 && crosses)};
}

/// Whether t would be beyond the farthest point of the triangle: with s = S - A and e = |B-A|₁ + |C-A|₁ a hit has t|V|₁
/// <= |s|₁ + e, so |T| |V|₁ <= det (|s|₁ + e).
bool is_far_beside(const Ray& ray, const kernel::PreparedTriangle<double>& triangle,
                   const kernel::TriangleFilter& filter) {
    const double n = triangle.norm(ray.ray.origin - triangle.A) + triangle.edges + ray.uncertainty();
    const double T = std::abs(filter.t_numerator) - filter.t_error;
    return T * triangle.norm(ray.ray.direction) > (filter.det + filter.error) * n * (1 + 0x1p-40);
}

/// The filter is the triangle's.
Hit exact_triangle_hit(const PreparedScene& scene, const Ray& ray, std::uint32_t object,
                       const kernel::TriangleFilter& filter) {
    if (!ray.start) {
        const kernel::TriangleHit hit = kernel::intersect(ray.ray, scene.triangle(object).triangle);
        const bool is_hit =
            hit.result == kernel::TriangleResult::hit && (hit.t > 0 || scene.boundary == Boundary::nonnegative);
        return is_hit ? Hit{hit.t, object} : Hit{};
    }
    if (is_far_beside(ray, scene.triangle(object), filter)) return {};
    const CramerSolution<Dyadic> form = triangle_form(scene, ray, object);
    if (classify(form) != TriangleHit::hit) return {};
    return {form.t_numerator.as_double() / form.det.as_double(), object};
}

Hit hit_sphere(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const Sphere<double>& sphere = scene.spheres[object];
    if (ray.starts_on(object)) {
        const Vec3<double>& d = ray.ray.direction;
        const double h = dot(d, Vec3<double>(ray.ray.origin - sphere.center));
        // For a grazing ray, rounding may point it outside. It then leaves the sphere at its start.
        return {h < 0 ? -2 * h / dot(d, d) : 0, object, true};
    }
    kernel::SphereFilter filter(ray.ray, sphere);
    kernel::allow_for_start(filter, ray.ray.origin - sphere.center, ray.uncertainty());
    if (!filter.is_known(kernel::SphereFilter::margin_for_t)) return exact_sphere_hit(scene, ray, object);
    return filter.is_hit() ? Hit{filter.root(), object, filter.c < 0} : Hit{};
}

Hit hit_triangle(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const kernel::PreparedTriangle<double>& triangle = scene.triangle(object);
    kernel::TriangleFilter filter(ray.ray, triangle);
    kernel::allow_for_start(filter, ray.ray.direction, ray.uncertainty(), triangle.edges);
    if (!filter.is_known_with_t()) {
        if (filter.det > filter.error && filter.inside < -filter.error) return {};
        return exact_triangle_hit(scene, ray, object, filter);
    }
    return filter.is_hit() ? Hit{filter.t(), object} : Hit{};
}

/// t of an object that is hit.
kernel::ExactT<Dyadic> exact_t(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
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

}  // namespace

Hit hit_object(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const bool is_own = ray.starts_on(object);
    if (is_own && !ray.start->is_inside) return {};
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: return hit_sphere(scene, ray, object);
        case ObjectKind::triangle: return is_own ? Hit{} : hit_triangle(scene, ray, object);
        case ObjectKind::cylinder: break;
    }
    return hit_cylinder(scene, ray, object);
}

std::partial_ordering order_exactly(const PreparedScene& scene, const Ray& ray, std::uint32_t first,
                                    std::uint32_t second) {
    return order(exact_t(scene, ray, first), exact_t(scene, ray, second));
}

bool is_hit_before_end(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const kernel::ExactT<Dyadic> end = kernel::Fraction{Dyadic(1), Dyadic(1)};
    return order(exact_t(scene, ray, object), end) < 0;
}

}  // namespace reference::render
