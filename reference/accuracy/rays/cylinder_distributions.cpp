#include <array>

#include "reference/accuracy/rays/distributions.h"

namespace reference::accuracy {
namespace {

CylinderCase drawn(Random& random, const CylinderCase& c) {
    if (!random.draws_floats()) return c;
    return {{as_float(c.ray.origin), as_float(c.ray.direction)},
            {as_float(c.cylinder.center), as_float(c.cylinder.radius), as_float(c.cylinder.height)}};
}

/// A ray from `distance` away that comes nearest to the axis at `offset` radii, `level` half heights above the center.
CylinderCase past_the_axis(Random& random, double radius, double distance, double offset, double level) {
    const P center = random.point(4), d = random.direction();
    const double height = radius * random.between(0.5, 3), aside = offset * radius / std::hypot(d.x, d.z);
    const P nearest = center + P(-d.z * aside, level * height / 2, d.x * aside);
    return drawn(random, {{nearest - scaled(d, distance), d}, {center, radius, height}});
}

CylinderCase benign_cylinder(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return past_the_axis(random, random.between(0.5, 2), random.between(8, 16), random.between(0, 1.5),
                         random.between(-1.2, 1.2));
}
CylinderCase grazing_the_tube(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const double near_one = 1 + random.number() * std::exp2(random.whole(-52, -18));
    return past_the_axis(random, random.between(0.5, 2), random.between(8, 16), near_one, random.between(-1, 1));
}
CylinderCase far_and_tiny_cylinder(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    return past_the_axis(random, random.between(0.001, 0.02), random.between(1e4, 1e6), random.between(0, 2),
                         random.between(-2, 2));
}
CylinderCase rim_aimed(std::uint64_t seed, Inputs inputs) {
    const Cylinder<double> cylinder = benign_cylinder(seed, inputs).cylinder;
    Random random(seed + 1, inputs);
    const P d = random.direction(), out = random.direction();
    const double aside = cylinder.radius / std::hypot(out.x, out.z);
    const P rim = cylinder.center + P(out.x * aside, std::copysign(cylinder.height / 2, out.y), out.z * aside);
    return drawn(random, {{rim - scaled(d, random.between(8, 16)), d}, cylinder});
}

/// A point of the surface (3k, y, 4k) of a tube with radius 5k, often on the rim or on a cap. Whole numbers.
struct SurfacePoint {
    Cylinder<double> cylinder;
    P point;

    explicit SurfacePoint(Random& random) {
        const double k = random.whole(1, 9), half = random.whole(1, 20);
        cylinder = {random.whole_point(9), 5 * k, 2 * half};
        const double y = random.whole(0, 1) == 0   ? random.whole(-4, 4) * half / 4
                         : random.whole(0, 1) == 0 ? half
                                                   : -half;
        point = cylinder.center + (random.whole(0, 1) == 0 ? P(3 * k, y, 4 * k) : P(-4 * k, y, 3 * k));
        if (random.whole(0, 4) == 0) point = cylinder.center + P(random.whole(-2, 2) * k, half, 0);
    }
};

/// A ray that goes through the point after a few steps or starts there; some of the numbers off by a few last places.
CylinderCase nudged_through(Random& random, const SurfacePoint& at, const P& d) {
    CylinderCase c{{at.point - scaled(d, static_cast<double>(random.whole(-1, 3))), d}, at.cylinder};
    if (random.inputs() == Inputs::floats) c.ray.origin = as_float(c.ray.origin);
    if (random.whole(0, 2) == 0) c.ray.origin = random.nudged(c.ray.origin);
    if (random.whole(0, 3) == 0) c.cylinder.radius = random.nudged(c.cylinder.radius);
    if (random.whole(0, 3) == 0) c.cylinder.height = random.nudged(c.cylinder.height);
    return c;
}
CylinderCase through_the_surface(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const SurfacePoint at(random);
    const P d = random.whole_point(3);
    CylinderCase c = nudged_through(random, at, d == P(0, 0, 0) ? P(0, 1, 0) : d);
    if (random.whole(0, 3) == 0) c.ray.direction = random.nudged(c.ray.direction);
    return c;
}
CylinderCase touching_the_tube(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const SurfacePoint at(random);
    const P out = at.point - at.cylinder.center;
    return nudged_through(random, at, {-out.z, out.x == 0 ? 1 : random.whole(-2, 2), out.x});
}
/// Parallel to the axis or to the caps, or almost.
CylinderCase along_the_surface(std::uint64_t seed, Inputs inputs) {
    Random random(seed, inputs);
    const SurfacePoint at(random);
    const bool upright = random.whole(0, 1) == 0;
    P d = upright ? P(0, random.whole(0, 1) == 0 ? -3 : 2, 0)
                  : P(random.whole(-3, 3), 0, random.whole(0, 1) == 0 ? 1 : -2);
    if (random.whole(0, 3) == 0) (upright ? d.x : d.y) = as_float(random.number() * std::exp2(-random.whole(1, 60)));
    return nudged_through(random, at, d);
}

}  // namespace

std::vector<Distribution<CylinderCase>> cylinder_distributions() {
    return {{"benign", benign_cylinder, Exists::in_floats, false},
            {"grazing", grazing_the_tube},
            {"far and tiny", far_and_tiny_cylinder},
            {"rim-aimed", rim_aimed},
            {"through the surface", through_the_surface},
            {"tangent", touching_the_tube},
            {"along the surface", along_the_surface}};
}

}  // namespace reference::accuracy
