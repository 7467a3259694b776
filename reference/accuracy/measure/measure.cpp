#include "reference/accuracy/measure/measure.h"

#include <time.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <tuple>
#include <utility>

#include "reference/accuracy/measure/statistics.h"
#include "reference/key/answer_key.h"

namespace reference::accuracy {
namespace {

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
    Drawn<Problem> drawn;
    Random seeds(seed);
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto& ray = drawn.rays.doubles.emplace_back(distribution.make_in_floats(seeds.bits()));
        drawn.rays.floats.push_back(in_floats(ray));
        drawn.truth.push_back(true_answer(ray));
    }
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
              const Distribution<Problem<double>>& distribution) {
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
    const std::uint64_t usual = options.quick ? 8'192 : 25'000;
    Measurement measurement{options.seed,
                            options.rays != 0 ? options.rays : usual,
                            options.quick ? 7 : 15,
                            compiler(),
                            RAYGRADE_FLAGS,
                            processor(),
                            0,
                            {},
                            {}};
    getloadavg(&measurement.load, 1);
    std::vector<std::function<void()>> steps;
    const auto add_steps = [&](Primitive primitive, const auto& methods, const auto& distributions) {
        for (const auto& distribution : distributions) {
            if (methods.empty() || distribution.exists == Exists::in_doubles_only) continue;
            steps.emplace_back(
                [&, primitive, distribution] { add_rows(measurement, primitive, methods, distribution); });
        }
    };
    add_steps(Primitive::sphere, ladder.spheres, sphere_distributions());
    add_steps(Primitive::triangle, ladder.triangles, triangle_distributions());
    add_steps(Primitive::cylinder, ladder.cylinders, cylinder_distributions());
    add_steps(Primitive::cast, ladder.casts, order_distributions());
    for (std::size_t done = 0; done < steps.size(); ++done) {
        steps[done]();
        if (options.progress) options.progress(static_cast<double>(done + 1) / static_cast<double>(steps.size()));
    }
    if (options.assignment != nullptr) time_keys(measurement, *options.assignment);
    return measurement;
}

Measurement measure(const MeasureOptions& options) {
    return measure(options, {sphere_methods(), triangle_methods(), cylinder_methods(), cast_methods()});
}

}  // namespace reference::accuracy
