#include "reference/accuracy/measure/measure.h"

#include <algorithm>
#include <stdexcept>

#include "reference/accuracy/measure/machine.h"
#include "reference/accuracy/measure/statistics.h"
#include "reference/accuracy/measure/timing.h"

namespace reference::accuracy {
namespace {

/// How much is measured.
struct Extent {
    std::uint64_t rays;
    int repetitions;
};

Extent extent_of(const MeasureOptions& options) {
    Extent extent = options.quick ? Extent{8'192, 7} : Extent{25'000, 15};
    if (options.rays != 0) extent.rays = options.rays;
    return extent;
}

bool is_asked_for(const std::string& method, const std::vector<std::string>& parts) {
    return parts.empty() || std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
               return method.find(part) != std::string::npos;
           });
}

template <class Methods>
Methods chosen(const Methods& methods, const std::vector<std::string>& parts) {
    Methods result;
    for (const auto& method : methods) {
        if (is_asked_for(method.name(), parts)) result.push_back(method);
    }
    return result;
}

void refuse_unknown(const std::vector<std::string>& parts, const Ladder& ladder) {
    for (const std::string& part : parts) {
        const auto is_known = [&](const auto& methods) {
            return std::any_of(methods.begin(), methods.end(),
                               [&](const auto& method) { return is_asked_for(method.name(), {part}); });
        };
        if (is_known(ladder.spheres) || is_known(ladder.triangles) || is_known(ladder.casts)) continue;
        throw std::invalid_argument("no method's name contains \"" + part + "\"");
    }
}

/// Reports the share that is done to options.progress.
class Progress {
  public:
    Progress(const MeasureOptions& options, std::size_t distributions)
        : tell_(options.progress), distributions_(static_cast<double>(distributions)) {}
    void set(double done_of_distribution) const {
        if (tell_) tell_(std::min(1.0, (finished_ + done_of_distribution) / distributions_));
    }
    void finish() {
        finished_ += 1;
        set(0);
    }

  private:
    const std::function<void(double)>& tell_;
    double distributions_;
    double finished_ = 0;
};

constexpr double share_of_truth = 0.3;  ///< roughly, as a share of a distribution's time
constexpr std::uint64_t rays_between_progress = 2'048;

/// Rays of one distribution, and the truth about them.
template <template <class> class Problem>
struct Drawn {
    Rays<Problem> rays;
    std::vector<TrueAnswer> truth;
};

template <template <class> class Problem>
Drawn<Problem> draw(const Distribution<Problem<double>>& distribution, std::uint64_t seed, std::uint64_t count,
                    const Progress& progress) {
    Drawn<Problem> drawn{draw_rays<Problem>(distribution, seed, count), {}};
    for (const Problem<double>& problem : drawn.rays.doubles) {
        if (drawn.truth.size() % rays_between_progress == 0) {
            progress.set(share_of_truth * static_cast<double>(drawn.truth.size()) / static_cast<double>(count));
        }
        drawn.truth.push_back(true_answer(problem));
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
    row.gives_t = method.gives_t;
    row.certain = method.certain;
    if (method.gives_t) row.t_error = t_error(answers, drawn.truth);
    return row;
}

/// Judges the methods first, which warms up the caches for the timing.
template <template <class> class Problem>
void add_rows(Measurement& measurement, Primitive primitive, const std::vector<Method<Problem>>& methods,
              const std::vector<Distribution<Problem<double>>>& distributions, Progress& progress) {
    if (methods.empty()) return;
    for (const auto& distribution : distributions) {
        if (distribution.exists == Exists::in_doubles_only) continue;
        const Drawn<Problem> drawn = draw<Problem>(distribution, measurement.seed, measurement.rays, progress);
        std::vector<Row> rows;
        for (const auto& method : methods) {
            Row& row = rows.emplace_back(judged_row(method, drawn));
            row.primitive = primitive;
            row.distribution = distribution.name;
            row.hard = distribution.hard;
        }
        Random order(measurement.seed);
        const auto timed = [&](const auto& loop) {
            const std::size_t count = drawn.truth.size();
            return time_of(count, [&] { loop(drawn.rays, count); });
        };
        const auto times = interleaved(
            methods.size(), measurement.repetitions, order, [&](std::size_t i) { return timed(methods[i].run); },
            [&](double done) { progress.set(share_of_truth + (1 - share_of_truth) * done); });
        for (std::size_t i = 0; i < rows.size(); ++i) set_time(rows[i], times[i]);
        if (!distribution.hard) {
            const auto latencies = interleaved(methods.size(), measurement.repetitions, order,
                                               [&](std::size_t i) { return timed(methods[i].chain); });
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].latency = quartiles_of(latencies[i]);
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

}  // namespace

Measurement measure(const MeasureOptions& options, const Ladder& ladder) {
    refuse_unknown(options.kernels, ladder);
    const Extent extent = extent_of(options);
    Measurement measurement{options.seed, extent.rays, extent.repetitions, compiler(), arithmetic_flags(),
                            processor(),  {}};
    const auto spheres = chosen(ladder.spheres, options.kernels);
    const auto triangles = chosen(ladder.triangles, options.kernels);
    const auto casts = chosen(ladder.casts, options.kernels);
    const auto sphere_rays = sphere_distributions();
    const auto triangle_rays = triangle_distributions();
    const auto cast_rays = order_distributions();
    Progress progress(options, count_measured(spheres, sphere_rays) + count_measured(triangles, triangle_rays) +
                                   count_measured(casts, cast_rays));
    add_rows(measurement, Primitive::sphere, spheres, sphere_rays, progress);
    add_rows(measurement, Primitive::triangle, triangles, triangle_rays, progress);
    add_rows(measurement, Primitive::cast, casts, cast_rays, progress);
    return measurement;
}

Measurement measure(const MeasureOptions& options) {
    return measure(options, {sphere_methods(), triangle_methods(), cast_methods()});
}

}  // namespace reference::accuracy
