// What a certified decision costs beside a naive one, on every distribution: nanoseconds a case.
// Ratios are those of one run: kernel_bench --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
//                                           --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <vector>

#include "reference/accuracy/distributions.h"
#include "reference/kernel/batch.h"
#include "reference/kernel/first.h"
#include "tests/bench/naive_kernels.h"

namespace {

namespace accuracy = reference::accuracy;

using namespace reference::kernel;
using reference::Sphere;
using reference::Triangle;
using reference::Vec3;
using reference::accuracy::OrderCase;
using reference::accuracy::SphereCase;
using reference::accuracy::TriangleCase;

/// More than a branch predictor remembers, and little enough for a second-level cache.
constexpr std::size_t case_count = 16384;

template <class T>
struct SphereInput {
    Ray<T> ray;
    Sphere<T> sphere;
    explicit SphereInput(const SphereCase& c)
        : ray{Vec3<T>(c.ray.origin), Vec3<T>(c.ray.direction)},
          sphere{Vec3<T>(c.sphere.center), static_cast<T>(c.sphere.radius)} {}
};
template <class T>
struct TriangleInput {
    Ray<T> ray;
    Triangle<T> triangle;
    explicit TriangleInput(const TriangleCase& c)
        : ray{Vec3<T>(c.ray.origin), Vec3<T>(c.ray.direction)},
          triangle{Vec3<T>(c.triangle.A), Vec3<T>(c.triangle.B), Vec3<T>(c.triangle.C)} {}
};
template <class T>
struct OrderInput {
    Ray<T> ray;
    Sphere<T> sphere;
    Triangle<T> triangle;
    explicit OrderInput(const OrderCase& c)
        : ray{Vec3<T>(c.ray.origin), Vec3<T>(c.ray.direction)},
          sphere{Vec3<T>(c.sphere.center), static_cast<T>(c.sphere.radius)},
          triangle{Vec3<T>(c.triangle.A), Vec3<T>(c.triangle.B), Vec3<T>(c.triangle.C)} {}
};

template <class T>
struct PreparedTriangleInput {
    Ray<T> ray;
    PreparedTriangle<T> triangle;
    explicit PreparedTriangleInput(const TriangleInput<T>& input) : ray(input.ray), triangle(input.triangle) {}
};
template <class T>
struct PreparedOrderInput {
    Ray<T> ray;
    Sphere<T> sphere;
    PreparedTriangle<T> triangle;
    explicit PreparedOrderInput(const OrderInput<T>& input)
        : ray(input.ray), sphere(input.sphere), triangle(input.triangle) {}
};

template <class Input, class Case>
std::vector<Input> drawn(const accuracy::Distribution<Case>& distribution) {
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < case_count; ++i) inputs.emplace_back(distribution.make(i));
    return inputs;
}

void count(benchmark::State& state) {
    const auto cases = static_cast<double>(case_count) * static_cast<double>(state.iterations());
    state.counters["case"] = benchmark::Counter(cases, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// `kernel` gives a number for each input, which is summed so that none is left out.
template <class Input, class Kernel>
void add(const std::string& name, const std::vector<Input>& inputs, Kernel kernel) {
    benchmark::RegisterBenchmark(name.c_str(), [inputs, kernel](benchmark::State& state) {
        for (auto _ : state) {
            auto sum = decltype(kernel(inputs[0])){};
            for (const Input& input : inputs) sum += kernel(input);
            benchmark::DoNotOptimize(sum);
        }
        count(state);
    });
}

template <class T>
void add_sphere(const std::string& type, const accuracy::Distribution<SphereCase>& distribution) {
    using Input = SphereInput<T>;
    const auto inputs = drawn<Input>(distribution);
    const auto name = [&](const char* kernel) {
        return "sphere/" + std::string(distribution.name) + "/" + type + " in/" + kernel;
    };
    add(name("naive float"), inputs, [](const Input& i) { return naive::sphere_t<float>(i.ray, i.sphere); });
    add(name("naive double"), inputs, [](const Input& i) { return naive::sphere_t<double>(i.ray, i.sphere); });
    add(name("decide"), inputs, [](const Input& i) { return static_cast<int>(decide(i.ray, i.sphere)); });
    add(name("fast t"), inputs, [](const Input& i) { return intersect_to_float(i.ray, i.sphere).t; });
    add(name("intersect"), inputs, [](const Input& i) { return intersect(i.ray, i.sphere).t; });
}

template <class T>
void add_triangle(const std::string& type, const accuracy::Distribution<TriangleCase>& distribution) {
    using Input = TriangleInput<T>;
    using Prepared = PreparedTriangleInput<T>;
    const auto inputs = drawn<Input>(distribution);
    const std::vector<Prepared> prepared(inputs.begin(), inputs.end());
    const auto name = [&](const char* kernel) {
        return "triangle/" + std::string(distribution.name) + "/" + type + " in/" + kernel;
    };
    add(name("naive float"), inputs,
        [](const Input& i) { return static_cast<int>(naive::triangle_is_hit<float>(i.ray, i.triangle)); });
    add(name("naive double"), inputs,
        [](const Input& i) { return static_cast<int>(naive::triangle_is_hit<double>(i.ray, i.triangle)); });
    add(name("naive double t"), inputs, [](const Input& i) { return naive::triangle_t<double>(i.ray, i.triangle); });
    add(name("decide"), inputs, [](const Input& i) { return static_cast<int>(decide(i.ray, i.triangle)); });
    add(name("decide, prepared"), prepared,
        [](const Prepared& i) { return static_cast<int>(decide(i.ray, i.triangle)); });
    add(name("fast t"), inputs, [](const Input& i) { return intersect_to_float(i.ray, i.triangle).t; });
    add(name("fast t, prepared"), prepared, [](const Prepared& i) { return intersect_to_float(i.ray, i.triangle).t; });
    add(name("intersect"), inputs, [](const Input& i) { return intersect(i.ray, i.triangle).t; });
}

template <class T>
void add_order(const std::string& type, const accuracy::Distribution<OrderCase>& distribution) {
    using Input = OrderInput<T>;
    using Prepared = PreparedOrderInput<T>;
    const auto inputs = drawn<Input>(distribution);
    const std::vector<Prepared> prepared(inputs.begin(), inputs.end());
    const auto name = [&](const char* kernel) {
        return "cast/" + std::string(distribution.name) + "/" + type + " in/" + kernel;
    };
    add(name("naive float"), inputs, [](const Input& i) { return naive::first<float>(i.ray, i.sphere, i.triangle).t; });
    add(name("naive double"), inputs,
        [](const Input& i) { return naive::first<double>(i.ray, i.sphere, i.triangle).t; });
    add(name("certified"), inputs, [](const Input& i) { return first_of(i.ray, i.sphere, i.triangle).t; });
    add(name("certified, prepared"), prepared,
        [](const Prepared& i) { return first_of(i.ray, i.sphere, i.triangle).t; });
}

/// All rays of the first distribution at one object: moved with their own to its place.
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
        count(state);
    });
}

/// The scalar form, writing what the batch writes.
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
    for (const auto& distribution : accuracy::sphere_distributions()) {
        add_sphere<float>("float", distribution);
        add_sphere<double>("double", distribution);
    }
    for (const auto& distribution : accuracy::triangle_distributions()) {
        add_triangle<float>("float", distribution);
        add_triangle<double>("double", distribution);
    }
    for (const auto& distribution : accuracy::order_distributions()) {
        add_order<float>("float", distribution);
        add_order<double>("double", distribution);
    }
    add_batches<float>("float");
    add_batches<double>("double");
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
