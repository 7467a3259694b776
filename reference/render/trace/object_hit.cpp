#include "reference/render/trace/object_hit.h"

#include <cmath>

#include "reference/render/trace/dyadic.h"
#include "reference/stages/order.h"

namespace reference::render {
namespace {

Vec3<Dyadic> exact(const Vec3<double>& p) {
    return {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)};
}
Triangle<Dyadic> exact(const Triangle<double>& triangle) {
    return {exact(triangle.A), exact(triangle.B), exact(triangle.C)};
}
Sphere<Dyadic> exact(const Sphere<double>& sphere) {
    return {exact(sphere.center), Dyadic(sphere.radius)};
}

bool is_sphere(const PreparedScene& scene, std::uint32_t object) {
    return object < scene.sphere_count;
}
const Triangle<double>& triangle_of(const PreparedScene& scene, std::uint32_t object) {
    return scene.triangles[object - scene.sphere_count].triangle;
}

Vec3<Dyadic> exact_start(const PreparedScene& /*scene*/, const CameraRay& ray) {
    return exact(ray.ray.origin);
}
Vec3<Dyadic> exact_start(const PreparedScene& scene, const SurfaceRay& ray) {
    if (is_sphere(scene, ray.start.object)) return exact(ray.start.point);
    const auto [A, B, C] = exact(triangle_of(scene, ray.start.object));
    return A + scaled(Vec3<Dyadic>(B - A), Dyadic(ray.start.u)) + scaled(Vec3<Dyadic>(C - A), Dyadic(ray.start.v));
}

Boundary boundary_of(const PreparedScene& scene, const CameraRay& /*ray*/) {
    return scene.boundary;
}
/// A surface ray has left the object that it starts on.
Boundary boundary_of(const PreparedScene& /*scene*/, const SurfaceRay& /*ray*/) {
    return Boundary::positive;
}

bool is_own(const CameraRay& /*ray*/, std::uint32_t /*object*/) {
    return false;
}
bool is_own(const SurfaceRay& ray, std::uint32_t object) {
    return ray.start.object == object;
}

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
        triangle_system(exact_start(scene, ray), exact(ray.ray.direction), exact(triangle_of(scene, object))));
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
    const Prepared& triangle = scene.triangles[object - scene.sphere_count];
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

template <class AnyRay>
ObjectHit exact_hit_of(const PreparedScene& scene, const AnyRay& ray, std::uint32_t object) {
    return is_sphere(scene, object) ? exact_sphere_hit(scene, ray, object) : exact_triangle_hit(scene, ray, object);
}

template <class AnyRay>
std::partial_ordering exact_order(const PreparedScene& scene, const AnyRay& ray, std::uint32_t one,
                                  std::uint32_t other) {
    if (is_sphere(scene, one)) {
        const SphereForm form = sphere_form(scene, ray, one);
        if (!is_sphere(scene, other)) {
            return order_of(form.quadratic, form.choice, triangle_form(scene, ray, other));
        }
        const SphereForm other_form = sphere_form(scene, ray, other);
        return order_of(form.quadratic, form.choice, other_form.quadratic, other_form.choice);
    }
    if (is_sphere(scene, other)) return 0 <=> exact_order(scene, ray, other, one);
    return order_of(triangle_form(scene, ray, one), triangle_form(scene, ray, other));
}

}  // namespace

ObjectHit exact_hit(const PreparedScene& scene, const CameraRay& ray, std::uint32_t object) {
    const bool counts_start = scene.boundary == Boundary::nonnegative;
    if (!is_sphere(scene, object)) {
        const kernel::TriangleHit hit = kernel::intersect(ray.ray, triangle_of(scene, object));
        return {hit.result == kernel::TriangleResult::hit && (hit.t > 0 || counts_start), false, hit.t};
    }
    const Sphere<double>& sphere = scene.spheres[object];
    const kernel::SphereHit hit = kernel::intersect(ray.ray, sphere);
    if (hit.result == kernel::SphereResult::miss) return {};
    const kernel::SphereFilter filter(ray.ray, sphere);
    // If the ray starts on or near the sphere, exact numbers decide which root counts and from which side.
    if (!(std::abs(filter.c) > 0x1p-48 * filter.m)) return exact_hit_of(scene, ray, object);
    return {true, filter.c < 0, hit.t};
}
ObjectHit exact_hit(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object) {
    return exact_hit_of(scene, ray, object);
}

std::partial_ordering order_exactly(const PreparedScene& scene, const CameraRay& ray, std::uint32_t one,
                                    std::uint32_t other) {
    return exact_order(scene, ray, one, other);
}
std::partial_ordering order_exactly(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t one,
                                    std::uint32_t other) {
    return exact_order(scene, ray, one, other);
}

bool is_hit_before_end(const PreparedScene& scene, const SurfaceRay& ray, std::uint32_t object) {
    if (!is_sphere(scene, object)) {
        const CramerSolution<Dyadic> form = triangle_form(scene, ray, object);
        const auto difference = sign_of(form.t_numerator - form.det);
        return sign_of(form.det) > 0 ? difference < 0 : difference > 0;
    }
    // The quadratic's value at 1 tells whether 1 is between the roots, and the middle of the roots tells on which side
    // it lies.
    const SphereForm form = sphere_form(scene, ray, object);
    const Quadratic<Dyadic>& quadratic = form.quadratic;
    const auto value = sign_of(quadratic.a + quadratic.b + quadratic.c);
    const bool middle_is_before = sign_of(Dyadic(2) * quadratic.a + quadratic.b) > 0;
    if (form.choice == RootChoice::smaller) return value < 0 || middle_is_before;
    return value > 0 && middle_is_before;
}

}  // namespace reference::render
