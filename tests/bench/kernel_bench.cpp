// Nanoseconds per ray of every method on every distribution, and of the kernel's blocks of rays and its single rays.
// Compare only figures of one run: kernel_bench --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
//                                           --benchmark_report_aggregates_only=true --benchmark_filter=benign
#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "reference/accuracy/methods/method.h"
#include "reference/kernel/batch.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace {

namespace accuracy = reference::accuracy;

using namespace reference::kernel;
using reference::Sphere;
using reference::Triangle;
using reference::Vec3;
using reference::accuracy::SphereCase;

/// More rays than a branch predictor remembers, and few enough for a second-level cache.
constexpr std::size_t case_count = 16384;

void count(benchmark::State& state, std::size_t rays) {
    const auto cases = static_cast<double>(rays) * static_cast<double>(state.iterations());
    state.counters["ray"] = benchmark::Counter(cases, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <template <class> class Problem>
void add_all(const std::string& primitive, const std::vector<accuracy::Method<Problem>>& methods,
             const std::vector<accuracy::Distribution<Problem<double>>>& distributions) {
    for (const auto& distribution : distributions) {
        if (distribution.exists == accuracy::Exists::in_doubles_only) continue;
        const auto rays =
            std::make_shared<const accuracy::Rays<Problem>>(accuracy::draw_rays<Problem>(distribution, 1, case_count));
        for (const auto& method : methods) {
            const std::string name = primitive + "/" + std::string(distribution.name) + "/" + method.name();
            benchmark::RegisterBenchmark(name.c_str(), [rays, method](benchmark::State& state) {
                for (auto _ : state) method.run(*rays, case_count);
                count(state, case_count);
            });
        }
    }
}

/// All rays of the first distribution, each moved together with its own object to the place of one object.
template <class T>
struct Block {
    std::array<std::vector<T>, 6> columns;
    void append(const Vec3<double>& origin, const Vec3<double>& direction) {
        for (int i = 0; i < 3; ++i) {
            columns[static_cast<std::size_t>(i)].push_back(static_cast<T>(origin[i]));
            columns[static_cast<std::size_t>(i + 3)].push_back(static_cast<T>(direction[i]));
        }
    }
    Rays<T> rays() const { return {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}}; }
};

template <class Object, class T, class Batch>
void add_batch(const std::string& name, const Block<T>& block, const Object& object, Batch batch) {
    benchmark::RegisterBenchmark(("batch/" + name).c_str(), [block, object, batch](benchmark::State& state) {
        using Result = decltype(decide(block.rays()[0], object));
        std::vector<Result> results(case_count);
        std::vector<double> ts(case_count);
        const Rays<T> rays = block.rays();
        for (auto _ : state) {
            batch(rays, object, std::span<Result>(results), std::span<double>(ts));
            benchmark::ClobberMemory();
        }
        count(state, case_count);
    });
}

/// The scalar form, with the same output as the batch.
const auto one_by_one = [](const auto& rays, const auto& object, auto results, auto) {
    for (std::size_t i = 0; i < rays.size(); ++i) results[i] = decide(rays[i], object);
};
const auto one_t_by_one = [](const auto& rays, const auto& object, auto results, auto ts) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto hit = intersect_to_float(rays[i], object);
        results[i] = hit.result;
        ts[i] = hit.t;
    }
};
const auto by_blocks = [](const auto& rays, const auto& object, auto results, auto) { decide(rays, object, results); };
const auto t_by_blocks = [](const auto& rays, const auto& object, auto results, auto ts) {
    intersect_to_float(rays, object, results, ts);
};

template <class T>
void add_batches(const std::string& type) {
    Block<T> at_sphere;
    const Sphere<double> sphere{Vec3<double>(0.5, -0.25, 1), 1.25};
    for (std::size_t i = 0; i < case_count; ++i) {
        const SphereCase c = accuracy::sphere_distributions().front().make(i);
        at_sphere.append(c.ray.origin - c.sphere.center + sphere.center, c.ray.direction);
    }
    const Sphere<T> object{Vec3<T>(sphere.center), static_cast<T>(sphere.radius)};
    add_batch("sphere/" + type + " in/decide, one by one", at_sphere, object, one_by_one);
    add_batch("sphere/" + type + " in/decide, block", at_sphere, object, by_blocks);
    add_batch("sphere/" + type + " in/fast t, one by one", at_sphere, object, one_t_by_one);
    add_batch("sphere/" + type + " in/fast t, block", at_sphere, object, t_by_blocks);
    Block<T> at_triangle;
    for (std::size_t i = 0; i < case_count; ++i) {
        const Ray<double> ray = accuracy::triangle_distributions().front().make(i).ray;
        at_triangle.append(ray.origin, ray.direction);
    }
    const Triangle<T> triangle{Vec3<T>(-2, -3, 0.5), Vec3<T>(3, -1, -1), Vec3<T>(0.5, 3, 1)};
    add_batch("triangle/" + type + " in/decide, one by one", at_triangle, triangle, one_by_one);
    add_batch("triangle/" + type + " in/decide, block", at_triangle, triangle, by_blocks);
    add_batch("triangle/" + type + " in/fast t, one by one", at_triangle, triangle, one_t_by_one);
    add_batch("triangle/" + type + " in/fast t, block", at_triangle, triangle, t_by_blocks);
}

}  // namespace

int main(int argc, char** argv) {
    add_all("sphere", accuracy::sphere_methods(), accuracy::sphere_distributions());
    add_all("triangle", accuracy::triangle_methods(), accuracy::triangle_distributions());
    add_all("cast", accuracy::cast_methods(), accuracy::order_distributions());
    add_batches<float>("float");
    add_batches<double>("double");
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
