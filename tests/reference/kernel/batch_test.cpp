// Compares blocks of rays with single rays, lane by lane.
#include "reference/kernel/batch.h"

#include <limits>

#include "reference/accuracy/rays/distributions.h"
#include "reference/accuracy/rays/random_numbers.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "tests/reference/kernel/any_precision.h"

namespace {

namespace accuracy = reference::accuracy;

using namespace reference::kernel;
using namespace any_precision;
using reference::accuracy::P;
using reference::accuracy::Random;

/// Any number of rays at one object, some similar to the given ray, some invalid.
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
        // GCC may fuse a * b + c in only one of the two, unless the build forbids it, as the reference's build does.
        if constexpr (is_contracted) {
            RC_ASSERT(ts[i] == single.t || std::abs(ts[i] - single.t) <= 0x1p-25 * single.t);
        } else {
            RC_ASSERT(ts[i] == single.t);
        }
    }
}

TEST(Batch, GivesWhatSingleRaysGive) {
    for (const auto& distribution : accuracy::sphere_distributions()) {
        for_seeds(distribution.name, 60, [&](std::uint64_t seed) {
            const accuracy::SphereCase c = distribution.make(seed);
            Random random(seed + 7);
            check_batch<float>(random, c.ray, object_of<float>(c.sphere));
            check_batch<double>(random, c.ray, c.sphere);
        });
    }
    for (const auto& distribution : accuracy::triangle_distributions()) {
        for_seeds(distribution.name, 60, [&](std::uint64_t seed) {
            const accuracy::TriangleCase c = distribution.make(seed);
            Random random(seed + 7);
            check_batch<float>(random, c.ray, object_of<float>(c.triangle));
            check_batch<double>(random, c.ray, c.triangle);
        });
    }
}

TEST(Batch, ReportsInvalidObjectsInEveryLane) {
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
