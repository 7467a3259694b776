#include "harness/report/accuracy/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/accuracy/log_axis.h"
#include "harness/report/accuracy/numbers.h"

namespace harness::report {
namespace {

using reference::accuracy::Row;

constexpr const char* time_title = "time for one benign ray, ns (logarithmic)";

ScatterPoint point_of(const Row& row, std::size_t place) {
    ScatterPoint point;
    point.number = static_cast<int>(place) + 1;
    point.name = method_name(row);
    point.scalar = row.scalar;
    point.x = row.ns_per_ray;
    point.x_low = row.ns_low;
    point.x_high = row.ns_high;
    return point;
}

std::string frontier_names(const Scatter& scatter) {
    std::string names;
    for (const ScatterPoint& point : scatter.points) {
        if (point.on_frontier) names += (names.empty() ? "" : "; ") + point.details;
    }
    return names.empty() ? "" : " On the frontier: " + names;
}

}  // namespace

/// The scale begins at the power of ten below the rate of one wrong ray among all, or below the lowest rate found.
Scatter wrong_scatter(const PrimitiveSummary& summary) {
    constexpr double million = 1e6;
    Scatter scatter{"wrong-" + name_of(summary.primitive), title_of(summary.primitive) + ": decisions", "", time_title,
                    "wrong decisions per million hard rays"};
    double least = million / 10;
    for (std::size_t i = 0; i < summary.methods.size(); ++i) {
        const Row& row = summary.methods[i].row;
        ScatterPoint& point = scatter.points.emplace_back(point_of(row, i));
        point.details = fmt::format("{}: {}, {} wrong per million hard rays (95 % interval {} to {})", point.name,
                                    time_text(row.ns_per_ray), rate_text(row.wrong_per_million),
                                    rate_text(row.wrong_low), rate_text(row.wrong_high));
        point.y = row.wrong_per_million;
        point.y_low = row.wrong_low;
        point.y_high = row.wrong_high;
        point.on_frontier = row.pareto_wrong;
        if (row.rays > 0) least = std::min(least, million / static_cast<double>(row.rays));
        if (point.y > 0) least = std::min(least, point.y);
    }
    scatter.least = decade_below(least);
    scatter.ceiling = million;
    scatter.band_title = "none wrong";
    scatter.description =
        fmt::format("{} methods by their time on benign rays and their wrong decisions on {} hard distributions.{}",
                    scatter.points.size(), summary.hard.size(), frontier_names(scatter));
    return scatter;
}

Scatter error_scatter(const PrimitiveSummary& summary) {
    constexpr double least_shown = 1e-12;  // a smaller error is far beyond the digits of a double's t
    Scatter scatter{"error-" + name_of(summary.primitive), title_of(summary.primitive) + ": t", "", time_title,
                    "mean error of t, ULP of float (logarithmic)"};
    double least = 1;
    bool any_below = false;
    for (std::size_t i = 0; i < summary.methods.size(); ++i) {
        const Row& row = summary.methods[i].row;
        if (!row.t_error) continue;
        const double error = row.t_error->mean_ulp;
        ScatterPoint& point = scatter.points.emplace_back(point_of(row, i));
        point.details =
            fmt::format("{}: {}, mean error {} ULP", point.name, time_text(row.ns_per_ray), error_text(error));
        point.y = point.y_low = point.y_high = error;
        point.on_frontier = row.pareto_error;
        if (error >= least_shown) least = std::min(least, error);
        any_below = any_below || error < least_shown;
    }
    scatter.least = decade_below(least);
    if (any_below) scatter.band_title = "below " + power_text(static_cast<int>(std::round(std::log10(scatter.least))));
    scatter.description = fmt::format("{} methods by their time and their mean error of t on benign rays.{}",
                                      scatter.points.size(), frontier_names(scatter));
    return scatter;
}

}  // namespace harness::report
