#include <array>

#include "reference/accuracy/rays/distributions.h"

namespace reference::accuracy {
namespace {

Triangle<double> random_triangle(Random& random, double size) {
    return {random.point(size), random.point(size), random.point(size)};
}
P mix(const Triangle<double>& t, double u, double v) {
    return t.A + scaled(P(t.B - t.A), u) + scaled(P(t.C - t.A), v);
}
Ray<double> aimed_at(Random& random, const P& target, double distance) {
    const P origin = target + scaled(random.direction(), distance);
    return {origin, target - origin};
}
/// Rounds the triangle to float if floats are drawn. This comes first, so that the ray is aimed at the rounded
/// triangle.
Triangle<double> float_or_double(Random& random, const Triangle<double>& t) {
    return random.draws_floats() ? Triangle<double>{as_float(t.A), as_float(t.B), as_float(t.C)} : t;
}
Ray<double> float_or_double(Random& random, const Ray<double>& ray) {
    return random.draws_floats() ? Ray<double>{as_float(ray.origin), as_float(ray.direction)} : ray;
}

TriangleCase at_inside(Random& random, const Triangle<double>& drawn, double u, double v, double distance) {
    const Triangle<double> triangle = float_or_double(random, drawn);
    return {float_or_double(random, aimed_at(random, mix(triangle, u, v), distance)), triangle};
}

TriangleCase benign_triangle(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return at_inside(random, random_triangle(random, 4), random.between(-0.5, 1.5), random.between(-0.5, 1.5), 8);
}
TriangleCase edge_aimed(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const double s = random.between(0, 1);
    const std::array<P, 3> uv{P(s, 0, 0), P(0, s, 0), P(s, 1 - s, 0)};
    const P& edge = uv[static_cast<std::size_t>(random.whole(0, 2))];
    return at_inside(random, random_triangle(random, 4), edge.x, edge.y, 8);
}
TriangleCase vertex_aimed(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const int corner = random.whole(0, 2);
    return at_inside(random, random_triangle(random, 4), corner == 1 ? 1 : 0, corner == 2 ? 1 : 0, 8);
}
Triangle<double> sliver(Random& random) {
    const P A = random.point(2);
    const P B = random.point(2);
    const P C = A + scaled(P(B - A), random.between(0.2, 0.8)) + random.point(std::exp2(random.whole(-50, -20)));
    return {A, B, C};
}
TriangleCase sliver_inside(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return at_inside(random, sliver(random), random.between(0, 0.5), random.between(0, 0.5), 4);
}
TriangleCase sliver_edge(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return at_inside(random, sliver(random), random.between(0, 1), 0, 4);
}
TriangleCase near_parallel(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const Triangle<double> t = float_or_double(random, random_triangle(random, 4));
    const P inside = mix(t, random.between(0, 1), random.between(0, 1));
    const P along = scaled(P(t.B - t.A), random.number()) + scaled(P(t.C - t.A), random.number());
    const P tilt = random.point(std::exp2(random.whole(-60, -10)));
    return {float_or_double(random, Ray<double>{inside - along + tilt, along + random.point(0x1p-50)}), t};
}
TriangleCase far_and_small(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const Triangle<double> t = random_triangle(random, 0.01);
    const double u = random.between(-0.2, 1.2);
    const double v = random.between(-0.2, 1.2);
    if (inputs == Inputs::mixed) return at_inside(random, t, u, v, 1e6);
    // At that distance, floats are farther apart than the triangle's corners. So the ray has few bits and passes
    // exactly through a target near the middle, and the triangle is moved to that target.
    const P target = scaled(random.whole_point(16), 0x1p-4);
    const P d = scaled(random.whole_point(256), 0x1p-8);
    const double steps = 16 * random.whole(30'000, 62'500);
    const P move = target - mix(t, u, v);
    return {{target - scaled(d, steps), d == P(0, 0, 0) ? P(0, 0, 1) : d},
            {as_float(t.A + move), as_float(t.B + move), as_float(t.C + move)}};
}
TriangleCase offset_1e6(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    Triangle<double> t = random_triangle(random, 4);
    const P offset = random.point(1e6);
    t = {t.A + offset, t.B + offset, t.C + offset};
    return at_inside(random, t, random.between(-0.2, 1.2), random.whole(0, 1) == 0 ? 0 : random.between(0, 1), 20);
}
TriangleCase tiny(std::uint64_t seed, Inputs inputs) {
    const TriangleCase c = edge_aimed(seed, inputs);
    const double factor = std::exp2(Random(seed + 1).whole(-110, -20));
    // The smallest floats have fewer bits.
    const auto shrunk = [&](const P& p) {
        return inputs == Inputs::floats ? as_float(scaled(p, factor)) : scaled(p, factor);
    };
    return {{shrunk(c.ray.origin), shrunk(c.ray.direction)},
            {shrunk(c.triangle.A), shrunk(c.triangle.B), shrunk(c.triangle.C)}};
}
TriangleCase triangle_at_the_ends_of_the_range(std::uint64_t seed, Inputs inputs) {
    const TriangleCase c = benign_triangle(seed, inputs);
    const double factor = to_the_ends(seed + 1);
    return {{scaled(c.ray.origin, factor), scaled(c.ray.direction, to_the_ends(seed + 2))},
            {scaled(c.triangle.A, factor), scaled(c.triangle.B, factor), scaled(c.triangle.C, factor)}};
}
TriangleCase integer_grid(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const P d = random.whole_point(3);
    return {{random.whole_point(4), d == P(0, 0, 0) ? P(0, 0, 1) : d},
            {random.whole_point(4), random.whole_point(4), random.whole_point(4)}};
}

}  // namespace

std::vector<Distribution<TriangleCase>> triangle_distributions() {
    return {{"benign", benign_triangle, Exists::in_floats, false},
            {"edge-aimed", edge_aimed},
            {"vertex-aimed", vertex_aimed},
            {"sliver", sliver_inside},
            {"sliver edge", sliver_edge},
            {"near-parallel", near_parallel},
            {"far and small", far_and_small},
            {"offset 1e6", offset_1e6},
            {"tiny", tiny},
            {"at the ends of the range", triangle_at_the_ends_of_the_range, Exists::in_doubles_only},
            {"integer grid", integer_grid}};
}

}  // namespace reference::accuracy
