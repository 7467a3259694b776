// Compares every decision and value of the kernel with fractions, on random rays of every distribution: the filters, t
// to float precision, and the exact level. RC_PARAMS sets the number of rays, and repeats a failure whose seed
// RapidCheck printed.
#include "reference/accuracy/rays/distributions.h"
#include "reference/accuracy/rays/random_numbers.h"
#include "reference/accuracy/rays/truth.h"
#include "reference/kernel/first.h"
#include "tests/given/ulp.h"
#include "tests/reference/kernel/random_cases.h"

namespace {

namespace accuracy = reference::accuracy;
namespace truth = reference::accuracy::truth;

using namespace reference::kernel;
using namespace random_cases;
using reference::FirstObject;
using reference::Sphere;
using reference::Subject;
using reference::Triangle;
using reference::accuracy::P;
using reference::accuracy::Random;

constexpr int level_rays_in_ci = 8000;

SphereResult true_result(const Ray<double>& ray, const Sphere<double>& sphere) {
    const bool valid = is_valid(ray) && is_finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
    return valid ? truth::sphere(ray, sphere).result : SphereResult::invalid;
}
TriangleResult true_result(const Ray<double>& ray, const Triangle<double>& triangle) {
    const bool valid = is_valid(ray) && is_finite(triangle.A) && is_finite(triangle.B) && is_finite(triangle.C);
    return valid ? truth::triangle(ray, triangle).result : TriangleResult::invalid;
}
truth::Real true_t(const Ray<double>& ray, const Sphere<double>& sphere) {
    return truth::sphere(ray, sphere).t();
}
truth::Real true_t(const Ray<double>& ray, const Triangle<double>& triangle) {
    return truth::real(truth::triangle(ray, triangle).t);
}

bool is_within_a_quarter_of_a_float(double t, const truth::Real& truth) {
    if (truth::is_within_one_ulp(t, truth)) return true;
    return abs(truth::Real(t) - truth) <= abs(truth) * truth::Real(0x1p-26);
}

void check_values(const Ray<double>& ray, const Sphere<double>& sphere) {
    RC_ASSERT(truth::is_within_one_ulp(intersect(ray, sphere).t, truth::sphere(ray, sphere).t()));
}
void check_values(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleHit given = intersect(ray, triangle);
    const truth::TriangleTruth truth = truth::triangle(ray, triangle);
    RC_ASSERT(truth::is_within_one_ulp(given.t, truth::real(truth.t)));
    RC_ASSERT(truth::is_within_one_ulp(given.u, truth::real(truth.u)));
    RC_ASSERT(truth::is_within_one_ulp(given.v, truth::real(truth.v)));
}

/// Checks all results for one ray and one object, from each level that may give them.
template <class Object>
void check_levels(const Ray<double>& ray, const Object& object) {
    const auto truth = true_result(ray, object);
    RC_ASSERT(decide(ray, object) == truth);
    RC_ASSERT(decide_exactly(ray, object) == truth);
    RC_ASSERT(intersect(ray, object).result == truth);
    const auto given = intersect_to_float(ray, object);
    RC_ASSERT(given.result == truth);
    if (!is_hit(truth)) {
        RC_ASSERT(given.t == 0);
    } else {
        RC_ASSERT(is_within_a_quarter_of_a_float(given.t, true_t(ray, object)));
        check_values(ray, object);
    }
}

TEST(Levels, DecideSpheres) {
    for (const auto& distribution : accuracy::sphere_distributions()) {
        for_seeds(distribution.name, level_rays_in_ci, [&](std::uint64_t seed) {
            const accuracy::SphereCase c = distribution.make(seed);
            check_levels(c.ray, c.sphere);
        });
    }
}

TEST(Levels, DecideTriangles) {
    for (const auto& distribution : accuracy::triangle_distributions()) {
        for_seeds(distribution.name, level_rays_in_ci, [&](std::uint64_t seed) {
            const accuracy::TriangleCase c = distribution.make(seed);
            check_levels(c.ray, c.triangle);
        });
    }
}

FirstHit::Kind true_first_hit(const Ray<double>& ray, const Sphere<double>& sphere, const Triangle<double>& triangle) {
    const auto at_sphere = true_result(ray, sphere);
    const auto at_triangle = true_result(ray, triangle);
    if (at_sphere == SphereResult::invalid || at_triangle == TriangleResult::invalid) return FirstHit::Kind::invalid;
    if (at_sphere == SphereResult::miss) return is_hit(at_triangle) ? FirstHit::Kind::triangle : FirstHit::Kind::none;
    if (!is_hit(at_triangle)) return FirstHit::Kind::sphere;
    const int order = truth::order(truth::sphere(ray, sphere), truth::triangle(ray, triangle).t);
    if (order == 0) return FirstHit::Kind::tie;
    return order < 0 ? FirstHit::Kind::sphere : FirstHit::Kind::triangle;
}

FirstHit::Kind kind_of(const First& first) {
    if (!first.object) return FirstHit::Kind::invalid;
    if (first.object == FirstObject::tie) return FirstHit::Kind::tie;
    if (first.object == FirstObject::no_hit) return FirstHit::Kind::none;
    return first.object->kind() == Subject::sphere ? FirstHit::Kind::sphere : FirstHit::Kind::triangle;
}

void check_first(const Ray<double>& ray, const Sphere<double>& sphere, const Triangle<double>& triangle) {
    const FirstHit given = first_of(ray, sphere, triangle);
    RC_ASSERT(given.kind == true_first_hit(ray, sphere, triangle));
    Cast cast;
    cast_ray(ray, {{sphere}, {triangle}}, cast);
    RC_ASSERT(kind_of(cast.first) == given.kind);
    if (given.kind == FirstHit::Kind::sphere || given.kind == FirstHit::Kind::tie) {
        RC_ASSERT(is_within_a_quarter_of_a_float(given.t, true_t(ray, sphere)));
    } else if (given.kind == FirstHit::Kind::triangle) {
        RC_ASSERT(is_within_a_quarter_of_a_float(given.t, true_t(ray, triangle)));
    } else {
        RC_ASSERT(given.t == 0);
    }
}

TEST(Levels, OrderASphereAndATriangle) {
    for (const auto& distribution : accuracy::order_distributions()) {
        for_seeds(distribution.name, level_rays_in_ci, [&](std::uint64_t seed) {
            const accuracy::OrderCase c = distribution.make(seed);
            check_first(c.ray, c.sphere, c.triangle);
        });
    }
}

/// Powers of two for numbers of few and of many bits.
int drawn_bits(Random& random) {
    static constexpr std::array around{28, 61, 125, 300, 900};
    return around[static_cast<std::size_t>(random.whole(0, 4))] + random.whole(-2, 2);
}

/// Rays that touch a sphere, an edge or both, exactly or almost. They start 2^bits away, or the coordinates of their
/// direction differ by a factor of 2^bits.
struct Spread {
    Ray<double> ray;
    Sphere<double> sphere;
    Triangle<double> triangle;

    explicit Spread(std::uint64_t seed) {
        Random random(seed);
        const double far = std::exp2(drawn_bits(random));
        const bool in_direction = random.whole(0, 1) == 0;
        const double step = random.whole(0, 1) == 0 ? 0 : std::exp2(-drawn_bits(random));
        const double size = random.whole(1, 5);
        sphere = {P(0, 0, 0), 5 * size};
        // The ray runs along the surface at (3, 4, 0), so that the coordinates of its direction may differ in size.
        const P d = in_direction ? P(4, -3, std::exp2(-drawn_bits(random))) : P(0, 0, -1);
        ray = {P(3 * size, 4 * size + step, 0) - reference::scaled(d, in_direction ? 1.0 : far), d};
        if (random.whole(0, 2) == 0) sphere.radius = random.nudged(sphere.radius);
        if (random.whole(0, 3) == 0) ray.origin.x = random.nudged(ray.origin.x);
        // The point (3, 4, 0) lies on the edge from B to C. The triangle's plane is z = 0 or contains the z axis.
        const double half = random.whole(1, 9);
        const P B = in_direction ? P(3 * size, 4 * size, -half) : P(3 * size - half, 4 * size, 0);
        const P C = in_direction ? P(3 * size, 4 * size, half) : P(3 * size + half, 4 * size, 0);
        triangle = {in_direction ? P(4 * size, 5 * size, 0) : P(3 * size, 7 * size, 0), B, C};
    }
};

TEST(Levels, AgreeOnNumbersOfManyBits) {
    for_seeds("spread", 5000, [](std::uint64_t seed) {
        const Spread c(seed);
        check_levels(c.ray, c.sphere);
        check_levels(c.ray, c.triangle);
        check_first(c.ray, c.sphere, c.triangle);
    });
}

/// A hit at a slant of 2^-45 to 1 and at a distance of 2^-45 to 1 times the direction. Whether it is a hit is decided
/// at a coarser level than its t.
TEST(Levels, DecideShallowRaysAndRaysFromNearThePlane) {
    for_seeds("shallow or near", 8000, [](std::uint64_t seed) {
        Random random(seed);
        const Triangle<double> triangle{random.point(4), random.point(4), random.point(4)};
        const P p = triangle.B - triangle.A;
        const P q = triangle.C - triangle.A;
        const P inside = triangle.A + reference::scaled(p, 0.3) + reference::scaled(q, random.between(0.2, 0.5));
        const P slant = reference::scaled(cross(p, q), std::exp2(-random.whole(0, 45)));
        const P d = reference::scaled(p, random.number()) + reference::scaled(q, random.number()) + slant;
        check_levels(Ray<double>{inside - reference::scaled(d, std::exp2(-random.whole(0, 45))), d}, triangle);
    });
}

/// A triangle through the point where the ray meets the sphere, shifted by 2^-52 to 2^-20 of the ray's way.
TEST(Levels, OrderATriangleAlmostWhereTheSphereIsHit) {
    const auto benign = accuracy::sphere_distributions().front();
    for_seeds("almost together", 8000, [&](std::uint64_t seed) {
        const accuracy::SphereCase c = benign.make(seed);
        Random random(seed + 1);
        const double t = intersect(c.ray, c.sphere).t * (1 + random.number() * std::exp2(-random.whole(20, 52)));
        const P at = c.ray.origin + reference::scaled(c.ray.direction, t);
        const P one = random.direction();
        const P other = random.direction();
        check_first(c.ray, c.sphere, Triangle<double>{at + one, at + other, at - one - other});
    });
}

}  // namespace
