#include "reference/kernel/first.h"

#include "reference/kernel/integers.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "reference/stages/order.h"

namespace reference::kernel {
namespace {

/// An object that is hit, with the t that the kernel computed for it.
struct Candidate {
    bool is_sphere;
    std::size_t index;
    double t;
};

/// Both t's are within one unit in the last place: a difference of 8u of the larger decides, if nothing is subnormal.
std::partial_ordering filtered_order(double one, double other) {
    const double slack = 0x1p-50 * std::max(one, other);
    if (!(slack > 0x1p-1000) || !std::isfinite(slack)) return std::partial_ordering::unordered;
    if (one - other < -slack) return std::partial_ordering::less;
    if (one - other > slack) return std::partial_ordering::greater;
    return std::partial_ordering::unordered;
}

RootChoice closed_root(const Quadratic<Integer>& quadratic) {
    return choose_root(quadratic, Boundary::nonnegative);
}

std::partial_ordering order_in_integers(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                                        const std::vector<Triangle<double>>& triangles) {
    const IntegerScene scene = as_integers(ray, spheres, triangles);
    if (triangles.empty()) {
        const Quadratic<Integer> one = quadratic_of(scene.ray, scene.spheres[0]);
        const Quadratic<Integer> other = quadratic_of(scene.ray, scene.spheres[1]);
        return order_of(one, closed_root(one), other, closed_root(other));
    }
    if (spheres.empty()) {
        return order_of(solution_of(scene.ray, scene.triangles[0]), solution_of(scene.ray, scene.triangles[1]));
    }
    const Quadratic<Integer> quadratic = quadratic_of(scene.ray, scene.spheres[0]);
    return order_of(quadratic, closed_root(quadratic), solution_of(scene.ray, scene.triangles[0]));
}

/// The order of a's t and b's t, where a is a sphere if only one of them is.
std::partial_ordering order(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                            const std::vector<Triangle<double>>& triangles, const Candidate& a, const Candidate& b) {
    const auto filtered = filtered_order(a.t, b.t);
    if (filtered != std::partial_ordering::unordered) return filtered;
    if (a.is_sphere && b.is_sphere) return order_in_integers(ray, {spheres[a.index], spheres[b.index]}, {});
    if (!a.is_sphere) return order_in_integers(ray, {}, {triangles[a.index], triangles[b.index]});
    return order_in_integers(ray, {spheres[a.index]}, {triangles[b.index]});
}

/// Spheres come before triangles, as `order` asks.
template <class Visit>
void for_each_hit(const Cast& cast, Visit visit) {
    for (std::size_t i = 0; i < cast.spheres.size(); ++i) {
        const SphereResult result = cast.spheres[i].result;
        if (result == SphereResult::hit || result == SphereResult::tangent) visit({true, i, cast.spheres[i].t});
    }
    for (std::size_t i = 0; i < cast.triangles.size(); ++i) {
        if (cast.triangles[i].result == TriangleResult::hit) visit({false, i, cast.triangles[i].t});
    }
}

bool holds_invalid(const Ray<double>& ray, const Cast& cast) {
    if (!is_valid(ray)) return true;
    for (const SphereHit& sphere : cast.spheres) {
        if (sphere.result == SphereResult::invalid) return true;
    }
    for (const TriangleHit& triangle : cast.triangles) {
        if (triangle.result == TriangleResult::invalid) return true;
    }
    return false;
}

}  // namespace

void cast_ray(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
              const std::vector<Triangle<double>>& triangles, Cast& result) {
    result.spheres.clear();
    result.triangles.clear();
    for (const Sphere<double>& sphere : spheres) result.spheres.push_back(intersect(ray, sphere));
    for (const Triangle<double>& triangle : triangles) result.triangles.push_back(intersect(ray, triangle));
    result.first = {First::Kind::none, 0};
    if (holds_invalid(ray, result)) {
        result.first.kind = First::Kind::invalid;
        return;
    }
    std::optional<Candidate> best;
    bool tie = false;
    for_each_hit(result, [&](const Candidate& candidate) {
        const auto compared = best ? order(ray, spheres, triangles, *best, candidate) : std::partial_ordering::greater;
        if (compared < 0) return;
        tie = compared == 0;
        if (!tie) best = candidate;
    });
    if (tie) {
        result.first.kind = First::Kind::tie;
    } else if (best) {
        result.first = {best->is_sphere ? First::Kind::sphere : First::Kind::triangle, best->index};
    }
}

}  // namespace reference::kernel
