#include <array>

#include "reference/accuracy/rays/distributions.h"

namespace reference::accuracy {
namespace {

/// A triangle with integer coordinates in a plane z = k, and a sphere that the ray meets at z = k from above: a tie.
OrderCase tie(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
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
OrderCase tie_or_one_ulp_off(std::uint64_t seed, Inputs inputs) {
    OrderCase c = tie(seed, inputs);
    const double z = Random(seed + 1, inputs).nudged(c.triangle.A.z, 1);
    c.triangle.A.z = c.triangle.B.z = c.triangle.C.z = z;
    return c;
}
/// The tie's triangle, tilted about the hit point: t stays the same fraction, which is not a double.
OrderCase tilted_tie(std::uint64_t seed, Inputs inputs) {
    OrderCase c = tie(seed, inputs);
    Random random(seed + 1, inputs);
    c.triangle.A.z += random.whole(-5, 5);
    c.triangle.B.z = 2 * c.triangle.C.z - c.triangle.A.z;
    c.triangle.A.x = c.triangle.B.x - 80;
    if (random.whole(0, 2) == 0) c.sphere.radius = random.nudged(c.sphere.radius);
    return c;
}

OrderCase benign_order(std::uint64_t seed, Inputs inputs) {
    const SphereCase s = sphere_distributions().front().draw(seed, inputs);
    Random random(seed + 1, inputs);
    const P target = s.sphere.center + random.point(2);
    const auto corner = [&] {
        const P p = target + random.point(5);
        return inputs == Inputs::floats ? as_float(p) : p;
    };
    return {s.ray, s.sphere, {corner(), corner(), corner()}};
}

}  // namespace

std::vector<Distribution<OrderCase>> order_distributions() {
    return {{"benign", benign_order, Exists::in_floats, false},
            {"tie or one ulp off", tie_or_one_ulp_off},
            {"tilted tie", tilted_tie}};
}

}  // namespace reference::accuracy
