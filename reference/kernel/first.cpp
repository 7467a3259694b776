#include "reference/kernel/first.h"

#include "reference/kernel/integers.h"

namespace reference::kernel {
namespace {

/// An object that is hit, with the t that the kernel computed for it.
struct Candidate {
    bool is_sphere;
    std::size_t index;
    double t;
};

/// Both t's are within one unit in the last place, so a difference above 8u of the larger t decides, if nothing is
/// subnormal.
std::partial_ordering filtered_order(double one, double other) {
    const double slack = 0x1p-50 * std::max(one, other);
    if (!(slack > 0x1p-1000) || !std::isfinite(slack)) return std::partial_ordering::unordered;
    if (one - other < -slack) return std::partial_ordering::less;
    if (one - other > slack) return std::partial_ordering::greater;
    return std::partial_ordering::unordered;
}

std::partial_ordering reversed(std::partial_ordering order) {
    return 0 <=> order;
}

/// The sign of (the sphere's t) - (the triangle's t), where both are hit. Let N/det be the triangle's t, with det > 0.
/// The sign of P = aN² + 2hN det + c det² tells whether it lies between the roots, and the sign of L = aN + h det on
/// which side of their middle.
template <class Quadratic, class Determinants>
std::partial_ordering exact_order(const Quadratic& sphere, const Determinants& triangle) {
    const auto N = triangle.t();
    const auto det = triangle.det();
    const auto aN = sphere.a * N;
    const auto h_det = sphere.h * det;
    const auto P = sign_of(N * (aN + h_det + h_det) + sphere.c * (det * det));
    const auto L_det = sign_of(aN + h_det);
    const auto L = sign_of(det) < 0 ? reversed(L_det) : L_det;
    const bool smaller = sphere.smaller_is_first();
    if (P < 0) return smaller ? std::partial_ordering::less : std::partial_ordering::greater;
    if (P > 0) return reversed(L);
    if (L == 0 || (L < 0) == smaller) return std::partial_ordering::equivalent;
    return L > 0 ? std::partial_ordering::less : std::partial_ordering::greater;
}

/// The sign of x + p√d + q√e by squaring; p and q are 1 or -1, d and e at least 0.
template <class X, class D>
std::partial_ordering sign_of_root_sum(const X& x, int p, const D& d, int q, const D& e) {
    const auto times = [](int factor, std::partial_ordering sign) { return factor > 0 ? sign : reversed(sign); };
    const auto roots = times(p, p == q ? sign_of(d + e) : sign_of(d - e));
    const auto rest = sign_of(x);
    if (rest == 0 || roots == rest) return roots;
    if (roots == 0) return rest;
    // The roots and x have opposite signs: compare (p√d + q√e)² = d + e + 2pq√(de) with x².
    const auto y = d + e - x * x;
    const auto de = d * e;
    const auto product = de + de + (de + de);
    const auto plain = sign_of(y);
    const auto more = times(p * q, sign_of(product));
    auto roots_win = plain;
    if (plain == 0 || more == plain) {
        roots_win = more;
    } else if (more != 0) {
        const auto larger = sign_of(y * y - product);
        roots_win = plain > 0 ? larger : reversed(larger);
    }
    if (roots_win == 0) return roots_win;
    return roots_win > 0 ? roots : rest;
}

/// The order of two spheres that are hit.
template <class A, class H, class C>
std::partial_ordering exact_order(const HalfQuadratic<A, H, C>& one, const HalfQuadratic<A, H, C>& other) {
    return sign_of_root_sum(other.h - one.h, one.smaller_is_first() ? -1 : 1, one.D(),
                            other.smaller_is_first() ? 1 : -1, other.D());
}

/// The order of two triangles that are hit.
template <class N, class E>
std::partial_ordering exact_order(const Determinants<N, E>& one, const Determinants<N, E>& other) {
    const auto one_det = one.det();
    const auto other_det = other.det();
    const auto difference = sign_of(one.t() * other_det - other.t() * one_det);
    return (sign_of(one_det) < 0) != (sign_of(other_det) < 0) ? reversed(difference) : difference;
}

auto exact_form(const auto& whole, const Ray<double>& ray, const Sphere<double>& sphere) {
    return quadratic_of(whole, ray, sphere);
}
auto exact_form(const auto& whole, const Ray<double>& ray, const Triangle<double>& triangle) {
    return determinants_of(whole, ray, triangle);
}

/// The order of two objects that are hit. A sphere must come before a triangle.
template <class One, class Other>
std::partial_ordering exact_order(const Ray<double>& ray, const One& one, const Other& other) {
    return in_whole_numbers(Scales(ray, one, other), [&](const auto& whole) {
        return exact_order(exact_form(whole, ray, one), exact_form(whole, ray, other));
    });
}

/// The order of a's t and b's t. If only one of them is a sphere, it must be a.
std::partial_ordering order(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                            const std::vector<Triangle<double>>& triangles, const Candidate& a, const Candidate& b) {
    const auto filtered = filtered_order(a.t, b.t);
    if (filtered != std::partial_ordering::unordered) return filtered;
    if (a.is_sphere && b.is_sphere) return exact_order(ray, spheres[a.index], spheres[b.index]);
    if (!a.is_sphere) return exact_order(ray, triangles[a.index], triangles[b.index]);
    return exact_order(ray, spheres[a.index], triangles[b.index]);
}

/// Visits spheres before triangles, as `order` requires.
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

std::partial_ordering order_exactly(const Ray<double>& ray, const Sphere<double>& sphere,
                                    const Triangle<double>& triangle) {
    return exact_order(ray, sphere, triangle);
}

std::partial_ordering order_exactly(const Ray<float>& ray, const Sphere<float>& sphere,
                                    const Triangle<float>& triangle) {
    return exact_order(as_double(ray), as_double(sphere), as_double(triangle));
}

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
