#include <array>

#include "tests/kernel/distributions.h"
#include "tests/kernel/random_numbers.h"

namespace distributions {
namespace {

using reference::scaled;

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

}  // namespace

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

}  // namespace distributions
