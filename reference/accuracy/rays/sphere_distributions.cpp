#include <array>

#include "reference/accuracy/rays/distributions.h"

namespace reference::accuracy {
namespace {

SphereCase as_drawn(Random& random, const SphereCase& c) {
    if (!random.draws_floats()) return c;
    return {{as_float(c.ray.origin), as_float(c.ray.direction)},
            {as_float(c.sphere.center), as_float(c.sphere.radius)}};
}

/// A ray that starts at `distance` and passes the centre at `offset` radii.
SphereCase passing(Random& random, double radius, double distance, double offset, double speed) {
    const P center = random.point(4);
    const P d = random.direction();
    const P side = cross(d, random.direction());
    const P unit_side = scaled(side, 1 / std::sqrt(dot(side, side)));
    const P origin = center + scaled(unit_side, offset * radius) - scaled(d, distance);
    return as_drawn(random, {{origin, scaled(d, speed)}, {center, radius}});
}

SphereCase benign_sphere(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return passing(random, random.between(0.5, 2), random.between(3, 12), random.between(0, 1.5), 1);
}
SphereCase grazing(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const double near_one = 1 + random.number() * std::exp2(random.whole(-52, -18));
    return passing(random, random.between(0.5, 2), random.between(3, 12), near_one, 1);
}
SphereCase far_and_tiny(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return passing(random, random.between(0.001, 0.02), random.between(1e4, 1e6), random.between(0, 2), 1);
}
SphereCase huge_and_near(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const double radius = random.between(1e5, 1e7);
    return passing(random, radius, radius * (1 + random.number() * 1e-7), random.between(0, 0.001), 1);
}
SphereCase on_the_surface(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const P center = random.point(2);
    const double radius = random.between(0.5, 2);
    return as_drawn(random, {{center + scaled(random.direction(), radius), random.direction()}, {center, radius}});
}
/// A start on the surface with integer coordinates, moved off by a tiny number in y; sometimes the radius is nudged,
/// too.
SphereCase a_hair_off_the_surface(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const double size = random.whole(1, 20);
    SphereCase c{{P(3 * size, 0, 4 * size), random.whole_point(4)}, {P(0, 0, 0), 5 * size}};
    if (c.ray.direction == P(0, 0, 0)) c.ray.direction = P(0, 0, 1);
    c.ray.origin.y = random.number() * std::exp2(random.whole(-1000, -1));
    if (random.whole(0, 3) == 0) c.sphere.radius = random.nudged(c.sphere.radius);
    return c;
}
SphereCase scaled_by_a_power_of_two(std::uint64_t seed, Inputs inputs) {
    const SphereCase c = grazing(seed, inputs);
    const double factor = std::exp2(Random(seed + 1).whole(0, 1) == 0 ? -60 : 60);
    return {{scaled(c.ray.origin, factor), c.ray.direction},
            {scaled(c.sphere.center, factor), c.sphere.radius * factor}};
}
SphereCase sphere_at_the_ends_of_the_range(std::uint64_t seed, Inputs inputs) {
    const SphereCase c = benign_sphere(seed, inputs);
    const double factor = to_the_ends(seed + 1);
    return {{scaled(c.ray.origin, factor), c.ray.direction},
            {scaled(c.sphere.center, factor), c.sphere.radius * factor}};
}
SphereCase non_unit_direction(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const double near_one = 1 + random.number() * std::exp2(random.whole(-40, -2));
    return passing(random, random.between(0.5, 2), random.between(3, 12), near_one, std::exp2(random.between(-30, 30)));
}

/// All numbers are integers. p has the integer length R and is perpendicular to d, so the ray touches the sphere
/// exactly.
SphereCase exact_tangent(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
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
SphereCase nearly_tangent_by_radius(std::uint64_t seed, Inputs inputs) {
    SphereCase c = exact_tangent(seed, inputs);
    Random random(seed + 1, inputs);
    c.sphere.radius = random.nudged(c.sphere.radius);
    if (inputs == Inputs::mixed && random.whole(0, 1) == 0) {
        const auto radius = static_cast<float>(c.sphere.radius);
        c.sphere.radius = static_cast<double>(std::nextafter(radius, random.whole(0, 1) == 0 ? 0.0F : 1e9F));
    }
    return c;
}
SphereCase nearly_tangent_by_ray(std::uint64_t seed, Inputs inputs) {
    SphereCase c = exact_tangent(seed, inputs);
    Random random(seed + 1, inputs);
    c.ray.origin = random.nudged(c.ray.origin);
    c.ray.direction = random.nudged(c.ray.direction);
    return c;
}

}  // namespace

std::vector<Distribution<SphereCase>> sphere_distributions() {
    return {{"benign", benign_sphere, Exists::in_floats, false},
            {"grazing", grazing},
            {"far and tiny", far_and_tiny},
            {"huge and near", huge_and_near},
            {"on the surface", on_the_surface},
            {"a hair off the surface", a_hair_off_the_surface, Exists::in_doubles_only},
            {"scaled by 2^60 or 2^-60", scaled_by_a_power_of_two},
            {"at the ends of the range", sphere_at_the_ends_of_the_range, Exists::in_doubles_only},
            {"non-unit direction", non_unit_direction},
            {"exact tangent", exact_tangent},
            {"nearly tangent by its radius", nearly_tangent_by_radius},
            {"nearly tangent by its ray", nearly_tangent_by_ray}};
}

}  // namespace reference::accuracy
