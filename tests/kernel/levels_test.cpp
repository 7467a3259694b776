// Each level of the kernel on its own against fractions: the filters for floats and for doubles, t as far as a float
// goes, the exact level at each size of its numbers, and blocks of rays against single ones.
#include <gtest/gtest.h>
// gtest comes first: RapidCheck's printers look for it.
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <limits>

#include "reference/kernel/batch.h"
#include "reference/kernel/first.h"
#include "tests/kernel/distributions.h"
#include "tests/kernel/oracle.h"
#include "tests/kernel/random_numbers.h"

namespace {

using namespace reference::kernel;
using distributions::P;
using distributions::Random;
using reference::Sphere;
using reference::Triangle;
using reference::Vec3;

template <class Check>
void for_seeds(std::string_view name, const char* rays, Check check) {
    setenv("RC_PARAMS", rays, 0);
    const auto seeds = rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    EXPECT_TRUE(rc::check(std::string(name), [&] { check(*seeds); }));
}
constexpr const char* rays_in_ci = "max_success=5000";

// Never inline: where g++ 12 sees doubles become floats and doubles again, two at a time, it leaves out the rounding.
#define ROUNDED __attribute__((noinline))
template <class T>
ROUNDED Ray<T> ray_of(const Ray<double>& ray) {
    return {Vec3<T>(ray.origin), Vec3<T>(ray.direction)};
}
template <class T>
ROUNDED Sphere<T> object_of(const Sphere<double>& sphere) {
    return {Vec3<T>(sphere.center), static_cast<T>(sphere.radius)};
}
template <class T>
ROUNDED Triangle<T> object_of(const Triangle<double>& triangle) {
    return {Vec3<T>(triangle.A), Vec3<T>(triangle.B), Vec3<T>(triangle.C)};
}

SphereResult true_result(const Ray<double>& ray, const Sphere<double>& sphere) {
    const bool valid = is_valid(ray) && is_finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
    return valid ? oracle::sphere(ray, sphere).result : SphereResult::invalid;
}
TriangleResult true_result(const Ray<double>& ray, const Triangle<double>& triangle) {
    const bool valid = is_valid(ray) && is_finite(triangle.A) && is_finite(triangle.B) && is_finite(triangle.C);
    return valid ? oracle::triangle(ray, triangle).result : TriangleResult::invalid;
}
oracle::Real true_t(const Ray<double>& ray, const Sphere<double>& sphere) {
    return oracle::sphere(ray, sphere).t();
}
oracle::Real true_t(const Ray<double>& ray, const Triangle<double>& triangle) {
    return oracle::real(oracle::triangle(ray, triangle).t);
}

bool is_within_a_quarter_of_a_float(double t, const oracle::Real& truth) {
    if (oracle::is_within_one_ulp(t, truth)) return true;
    return abs(oracle::Real(t) - truth) <= abs(truth) * oracle::Real(0x1p-26);
}

bool is_hit(SphereResult result) {
    return result == SphereResult::hit || result == SphereResult::tangent;
}
bool is_hit(TriangleResult result) {
    return result == TriangleResult::hit;
}

/// All that is said of one ray and one object of T, by each level that may say it.
template <class T, class Object>
void check_levels(const Ray<T>& ray, const Object& object) {
    const Ray<double> exact_ray = as_double(ray);
    const auto exact_object = as_double(object);
    const auto truth = true_result(exact_ray, exact_object);
    RC_ASSERT(decide(ray, object) == truth);
    RC_ASSERT(decide_exactly(exact_ray, exact_object) == truth);
    const auto given = intersect_to_float(ray, object);
    RC_ASSERT(given.result == truth);
    if (!is_hit(truth)) {
        RC_ASSERT(given.t == 0);
    } else {
        RC_ASSERT(is_within_a_quarter_of_a_float(given.t, true_t(exact_ray, exact_object)));
    }
}

template <class T>
void check_spheres() {
    for (const auto& distribution : distributions::spheres()) {
        for_seeds(distribution.name, rays_in_ci, [&](std::uint64_t seed) {
            const distributions::SphereCase c = distribution.make(seed);
            check_levels(ray_of<T>(c.ray), object_of<T>(c.sphere));
        });
    }
}
TEST(Levels, SpheresInFloats) {
    check_spheres<float>();
}
TEST(Levels, SpheresInDoubles) {
    check_spheres<double>();
}

template <class T>
void check_triangles() {
    for (const auto& distribution : distributions::triangles()) {
        for_seeds(distribution.name, rays_in_ci, [&](std::uint64_t seed) {
            const distributions::TriangleCase c = distribution.make(seed);
            check_levels(ray_of<T>(c.ray), object_of<T>(c.triangle));
        });
    }
}
TEST(Levels, TrianglesInFloats) {
    check_triangles<float>();
}
TEST(Levels, TrianglesInDoubles) {
    check_triangles<double>();
}

template <class T>
First::Kind true_first(const Ray<T>& ray, const Sphere<T>& sphere, const Triangle<T>& triangle) {
    const auto at_sphere = true_result(as_double(ray), as_double(sphere));
    const auto at_triangle = true_result(as_double(ray), as_double(triangle));
    if (at_sphere == SphereResult::invalid || at_triangle == TriangleResult::invalid) return First::Kind::invalid;
    if (at_sphere == SphereResult::miss) return is_hit(at_triangle) ? First::Kind::triangle : First::Kind::none;
    if (!is_hit(at_triangle)) return First::Kind::sphere;
    const int order = oracle::order(oracle::sphere(as_double(ray), as_double(sphere)),
                                    oracle::triangle(as_double(ray), as_double(triangle)).t);
    if (order == 0) return First::Kind::tie;
    return order < 0 ? First::Kind::sphere : First::Kind::triangle;
}

template <class T>
void check_first(const Ray<T>& ray, const Sphere<T>& sphere, const Triangle<T>& triangle) {
    const FirstHit given = first_of(ray, sphere, triangle);
    RC_ASSERT(given.kind == true_first(ray, sphere, triangle));
    if (given.kind == First::Kind::sphere || given.kind == First::Kind::tie) {
        RC_ASSERT(is_within_a_quarter_of_a_float(given.t, true_t(as_double(ray), as_double(sphere))));
    } else if (given.kind == First::Kind::triangle) {
        RC_ASSERT(is_within_a_quarter_of_a_float(given.t, true_t(as_double(ray), as_double(triangle))));
    } else {
        RC_ASSERT(given.t == 0);
    }
}

TEST(Levels, TheFirstOfASphereAndATriangle) {
    for (const auto& distribution : distributions::orders()) {
        for_seeds(distribution.name, rays_in_ci, [&](std::uint64_t seed) {
            const distributions::OrderCase c = distribution.make(seed);
            check_first(c.ray, c.sphere, c.triangle);
            check_first(ray_of<float>(c.ray), object_of<float>(c.sphere), object_of<float>(c.triangle));
        });
    }
}

/// Powers of two at which the numbers of the exact level get a word longer, and some beyond.
int drawn_bits(Random& random) {
    static constexpr std::array around{28, 61, 62, 125, 126, 300, 900};
    return around[static_cast<std::size_t>(random.whole(0, 6))] + random.whole(-2, 2);
}

/// A ray that touches a sphere, an edge, and both at once, or is a hair off, from 2^bits away, or with a direction
/// whose coordinates are 2^bits apart.
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
        // Along the surface at (3, 4, 0), so that the coordinates of the direction may differ in size.
        const P d = in_direction ? P(4, -3, std::exp2(-drawn_bits(random))) : P(0, 0, -1);
        ray = {P(3 * size, 4 * size + step, 0) - reference::scaled(d, in_direction ? 1.0 : far), d};
        if (random.whole(0, 2) == 0) sphere.radius = random.nudged(sphere.radius);
        if (random.whole(0, 3) == 0) ray.origin.x = random.nudged(ray.origin.x);
        // With (3, 4, 0) on the edge from B to C, in the plane z = 0 or the one that holds the z axis.
        const double half = random.whole(1, 9);
        const P B = in_direction ? P(3 * size, 4 * size, -half) : P(3 * size - half, 4 * size, 0);
        const P C = in_direction ? P(3 * size, 4 * size, half) : P(3 * size + half, 4 * size, 0);
        triangle = {in_direction ? P(4 * size, 5 * size, 0) : P(3 * size, 7 * size, 0), B, C};
    }
};

TEST(Levels, EachSizeOfTheExactLevel) {
    for_seeds("spread", "max_success=20000", [](std::uint64_t seed) {
        const Spread c(seed);
        check_levels(c.ray, c.sphere);
        check_levels(c.ray, c.triangle);
        check_first(c.ray, c.sphere, c.triangle);
        check_levels(ray_of<float>(c.ray), object_of<float>(c.sphere));
    });
}

/// Rays at one object, some like the given one, some invalid, of any number.
template <class T>
struct Columns {
    std::array<std::vector<T>, 6> columns;

    Columns(Random& random, const Ray<double>& given) {
        static constexpr T nan = std::numeric_limits<T>::quiet_NaN();
        static constexpr T infinite = std::numeric_limits<T>::infinity();
        const int size = random.whole(0, 300);
        for (int i = 0; i < size; ++i) {
            Ray<T> ray = ray_of<T>({random.nudged(given.origin), random.nudged(given.direction)});
            if (random.whole(0, 1) == 0) ray.origin += ray_of<T>({random.direction(), random.direction()}).direction;
            switch (random.whole(0, 20)) {
                case 0: ray.direction = Vec3<T>(0, 0, 0); break;
                case 1: ray.direction[random.whole(0, 2)] = nan; break;
                case 2: ray.origin[random.whole(0, 2)] = random.whole(0, 1) == 0 ? nan : -infinite; break;
                case 3: ray.direction[random.whole(0, 2)] = infinite; break;
                default: break;
            }
            for (int j = 0; j < 3; ++j) {
                columns[static_cast<std::size_t>(j)].push_back(ray.origin[j]);
                columns[static_cast<std::size_t>(j + 3)].push_back(ray.direction[j]);
            }
        }
    }
    Rays<T> rays() const { return {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}}; }
};

#ifdef KERNEL_IS_CONTRACTED
constexpr bool is_contracted = true;
#else
constexpr bool is_contracted = false;
#endif

template <class T, class Object>
void check_batch(Random& random, const Ray<double>& given, const Object& object) {
    const Columns<T> columns(random, given);
    const Rays<T> rays = columns.rays();
    using Result = decltype(decide(rays[0], object));
    std::vector<Result> decided(rays.size());
    std::vector<Result> measured(rays.size());
    std::vector<double> ts(rays.size(), -1);
    decide(rays, object, decided);
    intersect_to_float(rays, object, measured, ts);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto single = intersect_to_float(rays[i], object);
        RC_ASSERT(decided[i] == decide(rays[i], object));
        RC_ASSERT(measured[i] == single.result);
        // GCC may fuse a * b + c in the one and not in the other, unless the build forbids it, as the reference's does.
        if constexpr (is_contracted) {
            RC_ASSERT(std::abs(ts[i] - single.t) <= 0x1p-25 * single.t);
        } else {
            RC_ASSERT(ts[i] == single.t);
        }
    }
}

TEST(Batch, GivesWhatSingleRaysGive) {
    for (const auto& distribution : distributions::spheres()) {
        for_seeds(distribution.name, "max_success=60", [&](std::uint64_t seed) {
            const distributions::SphereCase c = distribution.make(seed);
            Random random(seed + 7);
            check_batch<float>(random, c.ray, object_of<float>(c.sphere));
            check_batch<double>(random, c.ray, c.sphere);
        });
    }
    for (const auto& distribution : distributions::triangles()) {
        for_seeds(distribution.name, "max_success=60", [&](std::uint64_t seed) {
            const distributions::TriangleCase c = distribution.make(seed);
            Random random(seed + 7);
            check_batch<float>(random, c.ray, object_of<float>(c.triangle));
            check_batch<double>(random, c.ray, c.triangle);
        });
    }
}

TEST(Batch, InvalidObjectsAreInvalidInEveryLane) {
    Random random(1);
    const Ray<double> ray{P(0, 0, 9), P(0, 0, -1)};
    for (const double radius : {0.0, -1.0, -0.0, HUGE_VAL, std::nan("")}) {
        check_batch<double>(random, ray, Sphere<double>{P(0, 0, 0), radius});
        check_batch<float>(random, ray, Sphere<float>{Vec3<float>(0, 0, 0), static_cast<float>(radius)});
        EXPECT_EQ(decide(ray, Sphere<double>{P(0, 0, 0), radius}), SphereResult::invalid);
    }
    check_batch<double>(random, ray, Triangle<double>{P(0, 0, HUGE_VAL), P(1, 0, 0), P(0, 1, 0)});
    check_batch<double>(random, ray, Triangle<double>{P(0, 0, 0), P(0, 0, 0), P(0, 1, 0)});
}

}  // namespace
