#include "harness/report/accuracy/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/accuracy/log_axis.h"
#include "harness/report/accuracy/numbers.h"

namespace harness::report {
namespace {

using reference::accuracy::Row;

constexpr double million = 1e6;

/// The scale begins at the power of ten below the rate of one wrong ray among `rays`, or below the lowest rate found.
void set_wrong_scale(Scatter& scatter, double rays) {
    double least = rays > 0 ? million / rays : 1;
    for (const ScatterPoint& point : scatter.points) {
        if (point.y > 0) least = std::min(least, point.y);
    }
    scatter.least = std::min(decade_below(least), million / 10);
    scatter.ceiling = million;
    scatter.band_title = "none wrong";
}

std::string frontier_names(const Scatter& scatter) {
    std::string names;
    for (const ScatterPoint& point : scatter.points) {
        if (point.on_frontier) names += (names.empty() ? "" : "; ") + point.details;
    }
    return names.empty() ? "" : " On the frontier: " + names;
}

std::string interval_text(double low, double high) {
    return fmt::format("95 % interval {} to {}", rate_text(low), rate_text(high));
}

}  // namespace

Scatter summary_scatter(const PrimitiveSummary& summary) {
    Scatter scatter{"summary-" + name_of(summary.primitive), title_of(summary.primitive), "",
                    "time for one benign ray, ns (logarithmic)", "wrong decisions per million hard rays"};
    double rays = 0;
    for (const MethodSummary& method : summary.methods) {
        const std::string name = method_name(method.kernel, method.scalar);
        const std::string worst = method.worst_set.empty() ? ""
                                                           : fmt::format("; worst on {}: {}", method.worst_set,
                                                                         rate_text(method.worst_per_million));
        scatter.points.push_back({static_cast<int>(scatter.points.size()) + 1, name,
                                  fmt::format("{}: {}, {} wrong per million hard rays ({}){}", name,
                                              time_text(method.ns), rate_text(method.wrong_per_million),
                                              interval_text(method.wrong_low, method.wrong_high), worst),
                                  method.scalar, method.ns, method.ns_low, method.ns_high, method.wrong_per_million,
                                  method.wrong_low, method.wrong_high, method.pareto_wrong});
        rays = std::max(rays, static_cast<double>(method.rays));
    }
    set_wrong_scale(scatter, rays);
    scatter.description =
        fmt::format("{} methods by their time on benign rays and their wrong decisions on {} hard distributions.{}",
                    summary.methods.size(), summary.hard.size(), frontier_names(scatter));
    return scatter;
}

Scatter wrong_scatter(const Panel& panel, const std::string& id) {
    Scatter scatter{id, fmt::format("{}, {}: decisions", title_of(panel.primitive), panel.distribution), "",
                    "time for one ray, ns (logarithmic)", "wrong decisions per million rays"};
    double rays = 0;
    for (const Row* row : panel.rows) {
        const std::string name = method_name(row->kernel, row->scalar);
        scatter.points.push_back(
            {static_cast<int>(scatter.points.size()) + 1, name,
             fmt::format("{}: {}, {} wrong per million ({})", name, time_text(row->ns_per_ray),
                         rate_text(row->wrong_per_million), interval_text(row->wrong_low, row->wrong_high)),
             row->scalar, row->ns_per_ray, row->ns_low, row->ns_high, row->wrong_per_million, row->wrong_low,
             row->wrong_high, row->pareto_wrong});
        rays = std::max(rays, static_cast<double>(row->rays));
    }
    set_wrong_scale(scatter, rays);
    scatter.description =
        fmt::format("{} methods by time and wrong decisions.{}", panel.rows.size(), frontier_names(scatter));
    return scatter;
}

Scatter error_scatter(const Panel& panel, const std::string& id) {
    constexpr double least_shown = 1e-12;  // a smaller error is far beyond the digits of a double's t
    Scatter scatter{id, fmt::format("{}, {}: t", title_of(panel.primitive), panel.distribution), "",
                    "time for one ray, ns (logarithmic)", "mean error of t, ULP of float (logarithmic)"};
    double least = 1;
    int number = 0;
    for (const Row* row : panel.rows) {
        ++number;
        if (!row->t_error) continue;
        const double error = row->t_error->mean_ulp;
        const std::string name = method_name(row->kernel, row->scalar);
        scatter.points.push_back(
            {number, name,
             fmt::format("{}: {}, mean error {} ULP, 99 % below {}, at most {}", name, time_text(row->ns_per_ray),
                         error_text(error), error_text(row->t_error->p99_ulp), error_text(row->t_error->max_ulp)),
             row->scalar, row->ns_per_ray, row->ns_low, row->ns_high, error, error, error, row->pareto_error});
        if (error >= least_shown) least = std::min(least, error);
    }
    scatter.least = decade_below(least);
    const bool any_below = std::any_of(scatter.points.begin(), scatter.points.end(),
                                       [&](const ScatterPoint& point) { return point.y < scatter.least; });
    if (any_below) scatter.band_title = "below " + power_text(static_cast<int>(std::round(std::log10(scatter.least))));
    scatter.description =
        fmt::format("{} methods by time and mean error of t.{}", scatter.points.size(), frontier_names(scatter));
    return scatter;
}

}  // namespace harness::report
