#include "tests/kernel/distributions.h"

#include <array>

#include "tests/kernel/random_numbers.h"

namespace distributions {
namespace {

using reference::cross;
using reference::scaled;

/// Half of all cases have float inputs, the others use all of a double's bits.
SphereCase mixed(Random& random, const SphereCase& c) {
    if (random.whole(0, 1) == 0) return c;
    return {{as_float(c.ray.origin), as_float(c.ray.direction)},
            {as_float(c.sphere.center), as_float(c.sphere.radius)}};
}

/// A ray from `distance` away that passes the centre at `offset` radii.
SphereCase passing(Random& random, double radius, double distance, double offset, double speed) {
    const P center = random.point(4);
    const P d = random.direction();
    const P side = cross(d, random.direction());
    const P unit_side = scaled(side, 1 / std::sqrt(dot(side, side)));
    const P origin = center + scaled(unit_side, offset * radius) - scaled(d, distance);
    return mixed(random, {{origin, scaled(d, speed)}, {center, radius}});
}

SphereCase benign_sphere(std::uint64_t seed) {
    Random random(seed);
    return passing(random, random.between(0.5, 2), random.between(3, 12), random.between(0, 1.5), 1);
}
SphereCase grazing(std::uint64_t seed) {
    Random random(seed);
    const double near_one = 1 + random.number() * std::exp2(random.whole(-52, -18));
    return passing(random, random.between(0.5, 2), random.between(3, 12), near_one, 1);
}
SphereCase far_and_tiny(std::uint64_t seed) {
    Random random(seed);
    return passing(random, random.between(0.001, 0.02), random.between(1e4, 1e6), random.between(0, 2), 1);
}
SphereCase huge_and_near(std::uint64_t seed) {
    Random random(seed);
    const double radius = random.between(1e5, 1e7);
    return passing(random, radius, radius * (1 + random.number() * 1e-7), random.between(0, 0.001), 1);
}
SphereCase on_the_surface(std::uint64_t seed) {
    Random random(seed);
    const P center = random.point(2);
    const double radius = random.between(0.5, 2);
    return mixed(random, {{center + scaled(random.direction(), radius), random.direction()}, {center, radius}});
}
/// As above with whole numbers and one of them nudged, sometimes by the smallest step a double has.
SphereCase a_hair_off_the_surface(std::uint64_t seed) {
    Random random(seed);
    const double size = random.whole(1, 20);
    SphereCase c{{P(3 * size, 0, 4 * size), random.whole_point(4)}, {P(0, 0, 0), 5 * size}};
    if (c.ray.direction == P(0, 0, 0)) c.ray.direction = P(0, 0, 1);
    c.ray.origin.y = random.number() * std::exp2(random.whole(-1000, -1));
    if (random.whole(0, 3) == 0) c.sphere.radius = random.nudged(c.sphere.radius);
    return c;
}
SphereCase scaled_by_a_power_of_two(std::uint64_t seed) {
    const SphereCase c = grazing(seed);
    const double factor = std::exp2(Random(seed + 1).whole(0, 1) == 0 ? -60 : 60);
    return {{scaled(c.ray.origin, factor), c.ray.direction},
            {scaled(c.sphere.center, factor), c.sphere.radius * factor}};
}
/// Where squares, cubes or fourth powers of the lengths leave the range of doubles, wholly or in part.
double to_the_ends(std::uint64_t seed) {
    static constexpr std::array<int, 8> exponents{-1000, -537, -530, -360, -268, 255, 340, 500};
    return std::exp2(exponents[static_cast<std::size_t>(Random(seed).whole(0, 7))]);
}
SphereCase sphere_at_the_ends_of_the_range(std::uint64_t seed) {
    const SphereCase c = benign_sphere(seed);
    const double factor = to_the_ends(seed + 1);
    return {{scaled(c.ray.origin, factor), c.ray.direction},
            {scaled(c.sphere.center, factor), c.sphere.radius * factor}};
}
SphereCase non_unit_direction(std::uint64_t seed) {
    Random random(seed);
    const double near_one = 1 + random.number() * std::exp2(random.whole(-40, -2));
    return passing(random, random.between(0.5, 2), random.between(3, 12), near_one, std::exp2(random.between(-30, 30)));
}

/// Whole numbers: p has the length of whole number R and is perpendicular to d, so the ray touches the sphere exactly.
SphereCase exact_tangent(std::uint64_t seed) {
    Random random(seed);
    static constexpr std::array<std::array<int, 4>, 8> quadruples{{{3, 4, 0, 5},
                                                                   {1, 2, 2, 3},
                                                                   {2, 3, 6, 7},
                                                                   {1, 4, 8, 9},
                                                                   {4, 4, 7, 9},
                                                                   {2, 6, 9, 11},
                                                                   {6, 6, 7, 11},
                                                                   {8, 9, 12, 17}}};
    const auto& q = quadruples[static_cast<std::size_t>(random.whole(0, 7))];
    const int size = random.whole(1, 60);
    P p(q[0] * size, q[1] * size, q[2] * size);
    if (random.whole(0, 1) == 0) p = {-p.z, p.x, p.y};
    P d = cross(p, random.whole_point(20));
    if (d == P(0, 0, 0)) d = cross(p, P(p.y, p.z, p.x + 1));
    const P center = random.whole_point(1000);
    return {{center + p - scaled(d, static_cast<double>(random.whole(-3, 40))), d},
            {center, static_cast<double>(q[3] * size)}};
}
SphereCase nearly_tangent_by_radius(std::uint64_t seed) {
    SphereCase c = exact_tangent(seed);
    Random random(seed + 1);
    c.sphere.radius = random.nudged(c.sphere.radius);
    if (random.whole(0, 1) == 0) {
        const auto radius = static_cast<float>(c.sphere.radius);
        c.sphere.radius = static_cast<double>(std::nextafter(radius, random.whole(0, 1) == 0 ? 0.0F : 1e9F));
    }
    return c;
}
SphereCase nearly_tangent_by_ray(std::uint64_t seed) {
    SphereCase c = exact_tangent(seed);
    Random random(seed + 1);
    c.ray.origin = random.nudged(c.ray.origin);
    c.ray.direction = random.nudged(c.ray.direction);
    return c;
}

reference::Triangle<double> random_triangle(Random& random, double size) {
    return {random.point(size), random.point(size), random.point(size)};
}
P mix(const reference::Triangle<double>& t, double u, double v) {
    return t.A + scaled(P(t.B - t.A), u) + scaled(P(t.C - t.A), v);
}
Ray<double> aimed_at(Random& random, const P& target, double distance) {
    const P origin = target + scaled(random.direction(), distance);
    return {origin, target - origin};
}
/// Rounds the triangle to float first, if that is drawn, so that the ray is aimed at what is left.
reference::Triangle<double> float_or_double(Random& random, const reference::Triangle<double>& t) {
    return random.whole(0, 1) == 0 ? t : reference::Triangle<double>{as_float(t.A), as_float(t.B), as_float(t.C)};
}
Ray<double> float_or_double(Random& random, const Ray<double>& ray) {
    return random.whole(0, 1) == 0 ? ray : Ray<double>{as_float(ray.origin), as_float(ray.direction)};
}

TriangleCase at_inside(Random& random, const reference::Triangle<double>& drawn, double u, double v, double distance) {
    const reference::Triangle<double> triangle = float_or_double(random, drawn);
    return {float_or_double(random, aimed_at(random, mix(triangle, u, v), distance)), triangle};
}

TriangleCase benign_triangle(std::uint64_t seed) {
    Random random(seed);
    return at_inside(random, random_triangle(random, 4), random.between(-0.5, 1.5), random.between(-0.5, 1.5), 8);
}
TriangleCase edge_aimed(std::uint64_t seed) {
    Random random(seed);
    const double s = random.between(0, 1);
    const std::array<P, 3> uv{P(s, 0, 0), P(0, s, 0), P(s, 1 - s, 0)};
    const P& edge = uv[static_cast<std::size_t>(random.whole(0, 2))];
    return at_inside(random, random_triangle(random, 4), edge.x, edge.y, 8);
}
TriangleCase vertex_aimed(std::uint64_t seed) {
    Random random(seed);
    const int corner = random.whole(0, 2);
    return at_inside(random, random_triangle(random, 4), corner == 1 ? 1 : 0, corner == 2 ? 1 : 0, 8);
}
reference::Triangle<double> sliver(Random& random) {
    const P A = random.point(2);
    const P B = random.point(2);
    const P C = A + scaled(P(B - A), random.between(0.2, 0.8)) + random.point(std::exp2(random.whole(-50, -20)));
    return {A, B, C};
}
TriangleCase sliver_inside(std::uint64_t seed) {
    Random random(seed);
    return at_inside(random, sliver(random), random.between(0, 0.5), random.between(0, 0.5), 4);
}
TriangleCase sliver_edge(std::uint64_t seed) {
    Random random(seed);
    return at_inside(random, sliver(random), random.between(0, 1), 0, 4);
}
TriangleCase near_parallel(std::uint64_t seed) {
    Random random(seed);
    const reference::Triangle<double> t = float_or_double(random, random_triangle(random, 4));
    const P inside = mix(t, random.between(0, 1), random.between(0, 1));
    const P along = scaled(P(t.B - t.A), random.number()) + scaled(P(t.C - t.A), random.number());
    const P tilt = random.point(std::exp2(random.whole(-60, -10)));
    return {float_or_double(random, Ray<double>{inside - along + tilt, along + random.point(0x1p-50)}), t};
}
TriangleCase far_and_small(std::uint64_t seed) {
    Random random(seed);
    return at_inside(random, random_triangle(random, 0.01), random.between(-0.2, 1.2), random.between(-0.2, 1.2), 1e6);
}
TriangleCase offset_1e6(std::uint64_t seed) {
    Random random(seed);
    reference::Triangle<double> t = random_triangle(random, 4);
    const P offset = random.point(1e6);
    t = {t.A + offset, t.B + offset, t.C + offset};
    return at_inside(random, t, random.between(-0.2, 1.2), random.whole(0, 1) == 0 ? 0 : random.between(0, 1), 20);
}
TriangleCase tiny(std::uint64_t seed) {
    const TriangleCase c = edge_aimed(seed);
    const double factor = std::exp2(Random(seed + 1).whole(-110, -20));
    return {{scaled(c.ray.origin, factor), scaled(c.ray.direction, factor)},
            {scaled(c.triangle.A, factor), scaled(c.triangle.B, factor), scaled(c.triangle.C, factor)}};
}
TriangleCase triangle_at_the_ends_of_the_range(std::uint64_t seed) {
    const TriangleCase c = benign_triangle(seed);
    const double factor = to_the_ends(seed + 1);
    return {{scaled(c.ray.origin, factor), scaled(c.ray.direction, to_the_ends(seed + 2))},
            {scaled(c.triangle.A, factor), scaled(c.triangle.B, factor), scaled(c.triangle.C, factor)}};
}
TriangleCase integer_grid(std::uint64_t seed) {
    Random random(seed);
    const P d = random.whole_point(3);
    return {{random.whole_point(4), d == P(0, 0, 0) ? P(0, 0, 1) : d},
            {random.whole_point(4), random.whole_point(4), random.whole_point(4)}};
}

/// A whole-number triangle in a plane z = k, and a sphere that the ray meets at z = k from above: a tie.
OrderCase tie(std::uint64_t seed) {
    Random random(seed);
    // (x, y, z) with length R lies on the sphere, and the ray comes down on it from above.
    static constexpr std::array<std::array<int, 4>, 4> points{
        {{3, 0, 4, 5}, {2, 3, 6, 7}, {1, 4, 8, 9}, {6, 2, 9, 11}}};
    const auto& q = points[static_cast<std::size_t>(random.whole(0, 3))];
    const int size = random.whole(1, 9);
    const P center = random.whole_point(50);
    const P hit = center + P(q[0] * size, q[1] * size, q[2] * size);
    const double up = random.whole(1, 40);
    const P d(0, 0, -random.whole(1, 7));
    const double spread = 40;
    return {{hit + P(0, 0, up), d},
            {center, static_cast<double>(q[3] * size)},
            {hit + P(-spread, -spread, 0), hit + P(spread, -spread, 0), hit + P(0, spread, 0)}};
}
OrderCase tie_or_one_ulp_off(std::uint64_t seed) {
    OrderCase c = tie(seed);
    const double z = Random(seed + 1).nudged(c.triangle.A.z, 1);
    c.triangle.A.z = c.triangle.B.z = c.triangle.C.z = z;
    return c;
}
/// The tie's triangle, tilted about the hit point: t stays the same fraction, which no double holds.
OrderCase tilted_tie(std::uint64_t seed) {
    OrderCase c = tie(seed);
    Random random(seed + 1);
    c.triangle.A.z += random.whole(-5, 5);
    c.triangle.B.z = 2 * c.triangle.C.z - c.triangle.A.z;
    c.triangle.A.x = c.triangle.B.x - 80;
    if (random.whole(0, 2) == 0) c.sphere.radius = random.nudged(c.sphere.radius);
    return c;
}
/// Two spheres that a ray down the z axis meets in the same point, from outside, from inside, or one from each.
SpherePairCase sphere_tie(std::uint64_t seed) {
    Random random(seed);
    static constexpr std::array<std::array<int, 4>, 4> points{
        {{3, 0, 4, 5}, {2, 3, 6, 7}, {1, 4, 8, 9}, {6, 2, 9, 11}}};
    const P hit = random.whole_point(50);
    const auto sphere_through_hit = [&] {
        const auto& q = points[static_cast<std::size_t>(random.whole(0, 3))];
        const int size = random.whole(1, 9);
        const double side = random.whole(0, 3) == 0 ? 1 : -1;
        return reference::Sphere<double>{hit + P(q[0] * size, q[1] * size, side * q[2] * size), 1.0 * q[3] * size};
    };
    // A step up of less than 2 * 4 stays inside a sphere whose lower half is met.
    const double up = random.whole(1, 7);
    return {{hit + P(0, 0, up), P(0, 0, -random.whole(1, 7))}, sphere_through_hit(), sphere_through_hit()};
}
SpherePairCase sphere_tie_or_one_ulp_off(std::uint64_t seed) {
    SpherePairCase c = sphere_tie(seed);
    Random random(seed + 1);
    c.other.radius = random.nudged(c.other.radius, 1);
    if (random.whole(0, 1) == 0) c.ray.direction.x = std::exp2(random.whole(-300, -20));
    return c;
}

OrderCase benign_order(std::uint64_t seed) {
    const SphereCase s = benign_sphere(seed);
    Random random(seed + 1);
    const P target = s.sphere.center + random.point(2);
    return {s.ray, s.sphere, {target + random.point(5), target + random.point(5), target + random.point(5)}};
}

}  // namespace

std::vector<Distribution<SphereCase>> spheres() {
    return {{"benign", benign_sphere},
            {"grazing", grazing},
            {"far and tiny", far_and_tiny},
            {"huge and near", huge_and_near},
            {"on the surface", on_the_surface},
            {"a hair off the surface", a_hair_off_the_surface},
            {"scaled by 2^60 or 2^-60", scaled_by_a_power_of_two},
            {"at the ends of the range", sphere_at_the_ends_of_the_range},
            {"non-unit direction", non_unit_direction},
            {"exact tangent", exact_tangent},
            {"nearly tangent by its radius", nearly_tangent_by_radius},
            {"nearly tangent by its ray", nearly_tangent_by_ray}};
}

std::vector<Distribution<TriangleCase>> triangles() {
    return {{"benign", benign_triangle},
            {"edge-aimed", edge_aimed},
            {"vertex-aimed", vertex_aimed},
            {"sliver", sliver_inside},
            {"sliver edge", sliver_edge},
            {"near-parallel", near_parallel},
            {"far and small", far_and_small},
            {"offset 1e6", offset_1e6},
            {"tiny", tiny},
            {"at the ends of the range", triangle_at_the_ends_of_the_range},
            {"integer grid", integer_grid}};
}

std::vector<Distribution<OrderCase>> orders() {
    return {{"benign", benign_order}, {"tie or one ulp off", tie_or_one_ulp_off}, {"tilted tie", tilted_tie}};
}

std::vector<Distribution<SpherePairCase>> sphere_pairs() {
    return {{"two spheres tied", sphere_tie}, {"two spheres tied or one ulp off", sphere_tie_or_one_ulp_off}};
}

}  // namespace distributions
