#include "reference/accuracy/measure/measure.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <tuple>

#include "reference/accuracy/measure/statistics.h"
#include "reference/key/answer_key.h"

namespace reference::accuracy {
namespace {

/// How much to measure.
struct Extent {
    std::uint64_t rays;
    int repetitions;
};

Extent extent_of(const MeasureOptions& options) {
    Extent extent = options.quick ? Extent{8'192, 7} : Extent{25'000, 15};
    if (options.rays != 0) extent.rays = options.rays;
    return extent;
}

/// Reports the finished share of the distributions to options.progress.
class Progress {
  public:
    Progress(const MeasureOptions& options, std::size_t distributions)
        : tell_(options.progress), distributions_(static_cast<double>(distributions)) {}
    void finish() {
        finished_ += 1;
        if (tell_) tell_(finished_ / distributions_);
    }

  private:
    const std::function<void(double)>& tell_;
    double distributions_;
    double finished_ = 0;
};

/// The processor time of this thread, without the time of other programs.
std::chrono::nanoseconds thread_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Nanoseconds for one of `count` rays.
template <class F>
double time_of(std::uint64_t count, F run) {
    const std::chrono::nanoseconds start = thread_time();
    run();
    const std::chrono::duration<double, std::nano> time = thread_time() - start;
    return time.count() / static_cast<double>(count);
}

/// Times every contestant once per repetition, each time in a new random order, so that disturbances of the machine
/// affect all of them alike. time(i) is the time of contestant i. Returns the times by contestant.
template <class F>
std::vector<std::vector<double>> interleaved(std::size_t contestants, int repetitions, Random& random, F time) {
    std::vector<std::vector<double>> times(contestants);
    std::vector<std::size_t> order(contestants);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[static_cast<std::size_t>(random.bits() % i)]);
        }
        for (const std::size_t i : order) times[i].push_back(time(i));
    }
    return times;
}

/// Rays of one distribution, and the truth about them.
template <template <class> class Problem>
struct Drawn {
    Rays<Problem> rays;
    std::vector<Answer> truth;
};

template <template <class> class Problem>
Drawn<Problem> draw(const Distribution<Problem<double>>& distribution, std::uint64_t seed, std::uint64_t count) {
    Drawn<Problem> drawn{draw_rays<Problem>(distribution, seed, count), {}};
    for (const Problem<double>& problem : drawn.rays.doubles) drawn.truth.push_back(true_answer(problem));
    return drawn;
}

template <template <class> class Problem>
Row judged_row(const Method<Problem>& method, const Drawn<Problem>& drawn) {
    const std::vector<Answer> answers = method.judge(drawn.rays, drawn.truth.size());
    Row row;
    row.kernel = method.kernel;
    row.scalar = method.scalar;
    row.source = method.source;
    set_wrong(row, wrong_answers(answers, drawn.truth), drawn.truth.size());
    row.certain = method.certain;
    row.t_error = t_error(answers, drawn.truth);
    return row;
}

/// Judges the methods first, which warms up the caches for the timing.
template <template <class> class Problem>
void add_rows(Measurement& measurement, Primitive primitive, const std::vector<Method<Problem>>& methods,
              const std::vector<Distribution<Problem<double>>>& distributions, Progress& progress) {
    if (methods.empty()) return;
    for (const auto& distribution : distributions) {
        if (distribution.exists == Exists::in_doubles_only) continue;
        const Drawn<Problem> drawn = draw<Problem>(distribution, measurement.seed, measurement.rays);
        std::vector<Row> rows;
        for (const auto& method : methods) {
            Row& row = rows.emplace_back(judged_row(method, drawn));
            row.primitive = primitive;
            row.distribution = distribution.name;
            row.hard = distribution.hard;
        }
        Random order(measurement.seed);
        const std::size_t count = drawn.truth.size();
        const auto times = interleaved(methods.size(), measurement.repetitions, order, [&](std::size_t i) {
            return time_of(count, [&] { methods[i].run(drawn.rays, count); });
        });
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Quartiles ns = quartiles_of(times[i]);
            std::tie(rows[i].ns_low, rows[i].ns_per_ray, rows[i].ns_high) = std::tuple(ns.low, ns.median, ns.high);
        }
        mark_pareto(rows);
        measurement.rows.insert(measurement.rows.end(), rows.begin(), rows.end());
        progress.finish();
    }
}

template <class Methods, class Distributions>
std::size_t count_measured(const Methods& methods, const Distributions& distributions) {
    if (methods.empty()) return 0;
    return static_cast<std::size_t>(
        std::count_if(distributions.begin(), distributions.end(),
                      [](const auto& distribution) { return distribution.exists == Exists::in_floats; }));
}

/// With its version: "g++ 12.2.0".
std::string compiler() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

/// Empty if the operating system gives no name.
std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t name = line.find_first_not_of(" :", line.find(':'));
        return name == std::string::npos ? "" : line.substr(name);
    }
    return "";
}

void time_keys(Measurement& measurement, const Assignment& assignment) {
    constexpr std::array precisions{Precision::float_, Precision::double_, Precision::certified};
    Random order(measurement.seed);
    const auto times = interleaved(precisions.size(), measurement.repetitions, order, [&](std::size_t i) {
        return time_of(1, [&] { keep(make_key(assignment, precisions.at(i))); });
    });
    constexpr double ms = 1e-6;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Quartiles ns = quartiles_of(times[i]);
        measurement.key_ms.at(i) = {ms * ns.low, ms * ns.median, ms * ns.high};
    }
}

}  // namespace

Measurement measure(const MeasureOptions& options, const Ladder& ladder) {
    const Extent extent = extent_of(options);
    Measurement measurement{options.seed, extent.rays, extent.repetitions, compiler(), RAYGRADE_FLAGS, processor(), 0,
                            {},           {}};
    getloadavg(&measurement.load, 1);
    const auto sphere_rays = sphere_distributions();
    const auto triangle_rays = triangle_distributions();
    const auto cast_rays = order_distributions();
    Progress progress(options, count_measured(ladder.spheres, sphere_rays) +
                                   count_measured(ladder.triangles, triangle_rays) +
                                   count_measured(ladder.casts, cast_rays));
    add_rows(measurement, Primitive::sphere, ladder.spheres, sphere_rays, progress);
    add_rows(measurement, Primitive::triangle, ladder.triangles, triangle_rays, progress);
    add_rows(measurement, Primitive::cast, ladder.casts, cast_rays, progress);
    if (options.assignment != nullptr) time_keys(measurement, *options.assignment);
    return measurement;
}

Measurement measure(const MeasureOptions& options) {
    return measure(options, {sphere_methods(), triangle_methods(), cast_methods()});
}

}  // namespace reference::accuracy
