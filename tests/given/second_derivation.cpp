#include "tests/given/second_derivation.h"

#include <cmath>

namespace second_derivation {
namespace {

struct Whole {
    mpz_class x, y, z;
};

Whole operator-(const Whole& p, const Whole& q) {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
}
mpz_class inner(const Whole& p, const Whole& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}
mpz_class volume(const Whole& p, const Whole& q, const Whole& r) {
    return p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
}

/// x times 2^1074: makes every finite double an integer and keeps the proportions of lengths and directions.
mpz_class whole(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    mpz_class result(std::ldexp(mantissa, 53));
    const int shift = exponent - 53 + 1074;
    if (shift >= 0) return result << static_cast<mp_bitcnt_t>(shift);
    return result >> static_cast<mp_bitcnt_t>(-shift);  // subnormal: only zero bits are shifted out
}
Whole whole(const reference::Vec3<double>& p) {
    return {whole(p.x), whole(p.y), whole(p.z)};
}

/// The ray's start and its point nearest to the centre, relative to the sphere.
struct Approach {
    Whole start;  ///< from the centre
    Whole direction;
    mpz_class ahead;  ///< the nearest point's t, times |direction|²
    mpz_class pace;   ///< |direction|²
    mpz_class R;
    int start_outside;    ///< 1 outside, 0 on the surface, -1 inside
    int nearest_outside;  ///< the same for the nearest point
};

Approach approach_of(const Ray<double>& ray, const Sphere<double>& sphere) {
    Approach a;
    a.start = whole(ray.origin) - whole(sphere.center);
    a.direction = whole(ray.direction);
    a.R = whole(sphere.radius);
    a.pace = inner(a.direction, a.direction);
    a.ahead = -inner(a.start, a.direction);
    const Whole nearest{a.start.x * a.pace + a.direction.x * a.ahead, a.start.y * a.pace + a.direction.y * a.ahead,
                        a.start.z * a.pace + a.direction.z * a.ahead};
    a.start_outside = cmp(inner(a.start, a.start), mpz_class(a.R * a.R));
    const mpz_class reach = a.R * a.pace;
    a.nearest_outside = cmp(inner(nearest, nearest), mpz_class(reach * reach));
    return a;
}

/// Whether the ray's point at t is outside the sphere: 1, 0 or -1 as above.
int outside_at(const Approach& a, const mpq_class& t) {
    const mpz_class& n = t.get_num();
    const mpz_class& d = t.get_den();
    const Whole p{a.start.x * d + a.direction.x * n, a.start.y * d + a.direction.y * n,
                  a.start.z * d + a.direction.z * n};
    const mpz_class reach = a.R * d;
    return cmp(inner(p, p), mpz_class(reach * reach));
}

}  // namespace

SphereResult decide(const Ray<double>& ray, const Sphere<double>& sphere) {
    const Approach a = approach_of(ray, sphere);
    if (a.nearest_outside > 0) return SphereResult::miss;
    if (a.nearest_outside == 0) return a.ahead >= 0 ? SphereResult::tangent : SphereResult::miss;
    const bool starts_in_or_on = a.start_outside <= 0;
    return starts_in_or_on || a.ahead > 0 ? SphereResult::hit : SphereResult::miss;
}

bool is_first_t_within(const Ray<double>& ray, const Sphere<double>& sphere, const mpq_class& lo, const mpq_class& hi) {
    const Approach a = approach_of(ray, sphere);
    if (a.start_outside == 0) return lo <= 0 && hi >= 0;
    const mpq_class nearest(a.ahead, a.pace);
    if (a.nearest_outside == 0) return lo * a.pace <= a.ahead && hi * a.pace >= a.ahead;
    if (a.start_outside < 0) return hi >= 0 && (lo <= 0 || outside_at(a, lo) <= 0) && outside_at(a, hi) >= 0;
    // The ray enters before its nearest point, from outside to inside.
    return lo * a.pace <= a.ahead && outside_at(a, lo) >= 0 && outside_at(a, hi) <= 0;
}

TriangleSolution solve(const Ray<double>& ray, const Triangle<double>& triangle) {
    const Whole origin = whole(ray.origin);
    const Whole d = whole(ray.direction);
    const Whole A = whole(triangle.A) - origin;
    const Whole B = whole(triangle.B) - origin;
    const Whole C = whole(triangle.C) - origin;
    const mpz_class at_A = volume(d, B, C);
    const mpz_class at_B = volume(d, C, A);
    const mpz_class at_C = volume(d, A, B);
    const mpz_class sum = at_A + at_B + at_C;
    const mpz_class height = volume(A, B, C);
    if (sum == 0) {
        // A triangle without area gives 0 for every direction. Three directions that span space tell it from a ray that
        // runs along the plane.
        const auto seen_along = [&](const Whole& axis) -> mpz_class {
            return volume(axis, B, C) + volume(axis, C, A) + volume(axis, A, B);
        };
        if (seen_along({1, 0, 0}) == 0 && seen_along({0, 1, 0}) == 0 && seen_along({0, 0, 1}) == 0) {
            return {TriangleResult::degenerate, 0, 0, 0};
        }
        return {height == 0 ? TriangleResult::coplanar : TriangleResult::miss, 0, 0, 0};
    }
    const auto share = [&](const mpz_class& part) {
        mpq_class result(part, sum);
        result.canonicalize();
        return result;
    };
    const int side = sgn(sum);
    const bool inside = sgn(at_A) * side >= 0 && sgn(at_B) * side >= 0 && sgn(at_C) * side >= 0;
    const bool ahead = sgn(height) * side >= 0;
    return {inside && ahead ? TriangleResult::hit : TriangleResult::miss, share(height), share(at_B), share(at_C)};
}

}  // namespace second_derivation
