#include "reference/render/visibility.h"

#include <cmath>

#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "reference/numbers/interval.h"
#include "reference/stages/triangle.h"

namespace reference::render {
namespace {

using kernel::Dyadic;
using kernel::over;
using Bounds = Interval<double>;
using Part = reference::CylinderPart;

Vec3<Dyadic> exact_start(const PreparedScene& scene, const Ray& ray) {
    if (!ray.start) return over<Dyadic>(ray.ray.origin);
    if (scene.kind_of(ray.start->object) != ObjectKind::triangle) return over<Dyadic>(ray.start->point);
    const auto [A, B, C] = over<Dyadic>(scene.triangle(ray.start->object).triangle);
    return A + scaled(Vec3<Dyadic>(B - A), Dyadic(ray.start->u)) + scaled(Vec3<Dyadic>(C - A), Dyadic(ray.start->v));
}

QuadraticRoot<Dyadic> sphere_root(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    Quadratic<Dyadic> quadratic =
        sphere_quadratic(exact_start(scene, ray), over<Dyadic>(ray.ray.direction), over<Dyadic>(scene.spheres[object]));
    if (!ray.starts_on(object)) return {quadratic, choose_root(quadratic, ray.boundary(scene))};
    quadratic.c = Dyadic();
    quadratic.d = quadratic.b * quadratic.b;
    return {quadratic, RootChoice::larger};
}

CramerSolution<Dyadic> triangle_solution(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    return solve_by_cramer(triangle_system(exact_start(scene, ray), over<Dyadic>(ray.ray.direction),
                                           over<Dyadic>(scene.triangle(object).triangle)));
}

Hit hit_sphere(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const Sphere<double>& sphere = scene.spheres[object];
    if (ray.starts_on(object)) {
        const Vec3<double>& d = ray.ray.direction;
        const double h = dot(d, Vec3<double>(ray.ray.origin - sphere.center));
        // Rounding may make a grazing ray point outside. It then leaves the sphere at its start.
        return {h < 0 ? -2 * h / dot(d, d) : 0, object, true};
    }
    kernel::SphereFilter filter(ray.ray, sphere);
    kernel::allow_for_start(filter, ray.ray.origin - sphere.center, ray.uncertainty());
    if (filter.is_known(kernel::SphereFilter::margin_for_t)) {
        return filter.is_hit() ? Hit{filter.root(), object, filter.c < 0} : Hit{};
    }
    const QuadraticRoot<Dyadic> root = sphere_root(scene, ray, object);
    if (root.choice == RootChoice::miss) return {};
    // If the ray starts on the sphere, a hit at t > 0 is reached through the inside.
    const auto c = sign_of(root.quadratic.c);
    const bool crosses = sign_of(root.quadratic.b) < 0 && root.choice == RootChoice::larger;
    return {kernel::nearest(root), object, c < 0 || (c == 0 && crosses)};
}

Hit hit_triangle(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    const kernel::PreparedTriangle& triangle = scene.triangle(object);
    kernel::TriangleFilter filter(ray.ray, triangle);
    kernel::allow_for_start(filter, ray.ray.direction, ray.uncertainty(), triangle.edges);
    if (filter.is_known_with_t()) return filter.is_hit() ? Hit{filter.t(), object} : Hit{};
    if (filter.det > filter.error && filter.inside < -filter.error) return {};
    const CramerSolution<Dyadic> solution = triangle_solution(scene, ray, object);
    const TriangleHit hit = classify(solution);
    const bool counts = hit == TriangleHit::boundary && ray.boundary(scene) == Boundary::nonnegative;
    if (hit != TriangleHit::hit && !counts) return {};
    return {kernel::nearest(fraction_of(solution)), object};
}

/// For a ray that starts on the cylinder: whether it starts exactly on that part.
template <class S>
CylinderEquations<S> cylinder_form(const PreparedScene& scene, const Ray& ray, std::uint32_t object,
                                   const Vec3<S>& start) {
    const Cylinder<S> cylinder = over<S>(scene.cylinder(object));
    CylinderEquations<S> form = kernel::doubled_equations(start, over<S>(ray.ray.direction), cylinder);
    if (!ray.starts_on(object)) return form;
    const S twice_height = cylinder.height + cylinder.height;
    switch (ray.start->part) {
        case kernel::CylinderPart::tube:
            form.tube.c = S();
            form.tube.d = form.tube.b * form.tube.b;
            break;
        case kernel::CylinderPart::top:
            form.top.numerator = S();
            form.bottom.numerator = -twice_height;
            break;
        case kernel::CylinderPart::bottom:
            form.top.numerator = twice_height;
            form.bottom.numerator = S();
            break;
    }
    return form;
}

/// For a ray that starts on the cylinder: where it leaves it. A grazing ray that points outside because of rounding
/// leaves it at its start: a miss.
template <class S>
Part part_of(const CylinderEquations<S>& form, const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    return ray.starts_on(object) ? crossed_part(form, false, Boundary::positive) : hit_part(form, ray.boundary(scene));
}

CylinderEquations<Dyadic> exact_form(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    return cylinder_form(scene, ray, object, exact_start(scene, ray));
}

/// The hit at t on this part.
Hit cylinder_hit(const Ray& ray, std::uint32_t object, Part part, double t) {
    const bool falls = ray.ray.direction.y < 0;
    switch (part) {
        case Part::tube_smaller_root: return {t, object, false, kernel::CylinderPart::tube};
        case Part::tube_larger_root: return {t, object, true, kernel::CylinderPart::tube};
        case Part::top_cap: return {t, object, !falls, kernel::CylinderPart::top};
        case Part::bottom_cap: return {t, object, falls, kernel::CylinderPart::bottom};
        case Part::miss:
        case Part::unsure: break;
    }
    return ray.starts_on(object) ? Hit{0, object, true, ray.start->part} : Hit{};
}

/// Whether the ray certainly misses the tube, seen from above.
bool misses_circle(const Ray& ray, const Cylinder<double>& cylinder) {
    kernel::SphereFilter filter = kernel::seen_from_above(ray.ray, cylinder);
    kernel::allow_for_start(filter, ray.ray.origin - cylinder.center, ray.uncertainty());
    return filter.is_known(1) && !filter.is_hit();
}

/// Uses intervals, and exact numbers if those leave a sign open, or do not give t to a relative error of 2^-27.
Hit hit_cylinder(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    if (!ray.starts_on(object) && misses_circle(ray, scene.cylinder(object))) return {};
    const Bounds off(-ray.uncertainty(), ray.uncertainty());
    const Vec3<Bounds> start = over<Bounds>(ray.ray.origin) + Vec3<Bounds>(off, off, off);
    const CylinderEquations<Bounds> bounds = cylinder_form(scene, ray, object, start);
    const Part part = part_of(bounds, scene, ray, object);
    if (part == Part::miss) return cylinder_hit(ray, object, part, 0);
    const Bounds t = cylinder_t(bounds, part).value_or(Bounds::whole());
    if (t.hi() - t.lo() <= 0x1p-27 * t.lo()) return cylinder_hit(ray, object, part, t.lo() + (t.hi() - t.lo()) / 2);
    const CylinderEquations<Dyadic> exact = exact_form(scene, ray, object);
    const Part exact_part = part_of(exact, scene, ray, object);
    const auto exact_t = hit_parameter(exact, exact_part);
    return cylinder_hit(ray, object, exact_part, exact_t ? kernel::nearest(*exact_t) : 0);
}

/// t of an object that is hit. If a ray leaves its own cylinder at its start, t is 0.
HitParameter<Dyadic> exact_t(const PreparedScene& scene, const Ray& ray, std::uint32_t object) {
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: return sphere_root(scene, ray, object);
        case ObjectKind::triangle: return fraction_of(triangle_solution(scene, ray, object));
        case ObjectKind::cylinder: break;
    }
    const CylinderEquations<Dyadic> form = exact_form(scene, ray, object);
    return hit_parameter(form, part_of(form, scene, ray, object)).value_or(Fraction<Dyadic>{Dyadic(0), Dyadic(1)});
}

/// Both t's are known to a relative error of 2^-26, so a difference above 2^-24 of them decides. No t except 0 is near
/// the smallest double, because no number of the scene is.
bool is_nearer(const PreparedScene& scene, const Ray& ray, const Hit& hit, const Hit& nearest) {
    const double difference = hit.t - nearest.t;
    if (std::abs(difference) > 0x1p-24 * hit.t) return difference < 0;
    const auto order = order_of(exact_t(scene, ray, hit.object), exact_t(scene, ray, nearest.object));
    return order < 0 || (order == 0 && hit.object < nearest.object);
}

bool is_before_end(const PreparedScene& scene, const Ray& ray, const Hit& hit, double end) {
    if (!hit.is_hit()) return false;
    if (hit.t < end * (1 - 0x1p-24)) return true;
    if (hit.t > end * (1 + 0x1p-24)) return false;
    const HitParameter<Dyadic> light = Fraction<Dyadic>{Dyadic(1), Dyadic(1)};
    return order_of(exact_t(scene, ray, hit.object), light) < 0;
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

Hit first_hit(const PreparedScene& scene, const Ray& ray) {
    Hit nearest;
    for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
        const Hit hit = hit_object(scene, ray, object);
        if (hit.is_hit() && is_nearer(scene, ray, hit, nearest)) nearest = hit;
    }
    return nearest;
}

bool is_blocked(const PreparedScene& scene, const Ray& ray, double end) {
    for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
        if (is_before_end(scene, ray, hit_object(scene, ray, object), end)) return true;
    }
    return false;
}

bool is_blocked_by_own(const PreparedScene& scene, const Ray& ray, double end) {
    return is_before_end(scene, ray, hit_object(scene, ray, ray.start->object), end);
}

}  // namespace reference::render
