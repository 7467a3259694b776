// Nanoseconds per ray of every method on every distribution.
// Compare only figures of one run: kernel_bench --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
//                                           --benchmark_report_aggregates_only=true --benchmark_filter=benign
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "reference/accuracy/methods/method.h"

namespace {

namespace accuracy = reference::accuracy;

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

}  // namespace

int main(int argc, char** argv) {
    add_all("sphere", accuracy::sphere_methods(), accuracy::sphere_distributions());
    add_all("triangle", accuracy::triangle_methods(), accuracy::triangle_distributions());
    add_all("cast", accuracy::cast_methods(), accuracy::order_distributions());
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
