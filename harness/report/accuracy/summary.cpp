#include "harness/report/accuracy/summary.h"

#include <algorithm>

#include "reference/accuracy/measure/statistics.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

bool is_of(const Row& row, const Row& method) {
    return row.primitive == method.primitive && row.kernel == method.kernel && row.scalar == method.scalar;
}

/// The mean over rows of a figure that a row may lack; empty if all do.
template <class Figure>
std::optional<double> mean(const std::vector<const Row*>& rows, Figure figure) {
    double sum = 0;
    double count = 0;
    for (const Row* row : rows) {
        const std::optional<double> number = figure(*row);
        sum += number.value_or(0);
        count += number ? 1 : 0;
    }
    return count == 0 ? std::nullopt : std::optional(sum / count);
}

MethodSummary summary_of(const Row& method, const PrimitiveSummary& primitive, const std::vector<Row>& rows) {
    MethodSummary summary{method, "", 0, {}};
    std::vector<const Row*> timed;
    std::uint64_t rays = 0;
    std::uint64_t wrong = 0;
    for (const Row& row : rows) {
        if (!is_of(row, method)) continue;
        if (!row.hard || primitive.benign.empty()) timed.push_back(&row);
        if (!row.hard && !primitive.hard.empty()) continue;
        summary.per_set.push_back(row.wrong_per_million);
        rays += row.rays;
        wrong += row.wrong;
        if (row.wrong_per_million <= summary.worst_per_million) continue;
        summary.worst_per_million = row.wrong_per_million;
        summary.worst_set = row.distribution;
    }
    const auto mean_of = [&](double Row::*figure) {
        return mean(timed, [&](const Row& row) { return std::optional(row.*figure); }).value_or(0);
    };
    summary.row.ns_per_ray = mean_of(&Row::ns_per_ray);
    summary.row.ns_low = mean_of(&Row::ns_low);
    summary.row.ns_high = mean_of(&Row::ns_high);
    const auto latency =
        mean(timed, [](const Row& row) { return row.latency ? std::optional(row.latency->median) : std::nullopt; });
    const auto error =
        mean(timed, [](const Row& row) { return row.t_error ? std::optional(row.t_error->mean_ulp) : std::nullopt; });
    summary.row.latency = latency ? std::optional(Quartiles{*latency, *latency, *latency}) : std::nullopt;
    summary.row.t_error = error ? std::optional(TError{*error, *error, *error}) : std::nullopt;
    if (rays > 0) set_wrong(summary.row, wrong, rays);
    return summary;
}

PrimitiveSummary summary_of(Primitive primitive, const std::vector<Row>& rows) {
    PrimitiveSummary summary{primitive, {}, {}, {}};
    for (const Row& row : rows) {
        std::vector<std::string>& names = row.hard ? summary.hard : summary.benign;
        const bool is_known = std::find(names.begin(), names.end(), row.distribution) != names.end();
        if (row.primitive == primitive && !is_known) names.push_back(row.distribution);
    }
    std::vector<Row> totals;
    for (const Row& row : rows) {
        const bool is_known = std::ranges::any_of(totals, [&](const Row& total) { return is_of(row, total); });
        if (row.primitive != primitive || is_known) continue;
        summary.methods.push_back(summary_of(row, summary, rows));
        totals.push_back(summary.methods.back().row);
    }
    mark_pareto(totals);
    for (std::size_t i = 0; i < totals.size(); ++i) summary.methods[i].row = totals[i];
    return summary;
}

}  // namespace

std::vector<PrimitiveSummary> summarize(const Measurement& measured) {
    std::vector<PrimitiveSummary> summaries;
    for (const Row& row : measured.rows) {
        const bool is_known = std::any_of(summaries.begin(), summaries.end(), [&](const PrimitiveSummary& summary) {
            return summary.primitive == row.primitive;
        });
        if (!is_known) summaries.push_back(summary_of(row.primitive, measured.rows));
    }
    return summaries;
}

std::vector<Panel> panels_of(const Measurement& measured) {
    std::vector<Panel> panels;
    for (const Row& row : measured.rows) {
        auto panel = std::find_if(panels.begin(), panels.end(), [&](const Panel& other) {
            return other.primitive == row.primitive && other.distribution == row.distribution;
        });
        if (panel == panels.end()) panel = panels.insert(panel, Panel{row.primitive, row.distribution, row.hard, {}});
        panel->rows.push_back(&row);
    }
    return panels;
}

std::string method_name(const Row& row) {
    return row.kernel + " " + row.scalar;
}

std::string title_of(Primitive primitive) {
    switch (primitive) {
        case Primitive::sphere: return "Ray and sphere";
        case Primitive::triangle: return "Ray and triangle";
        case Primitive::cast: return "The whole cast";
    }
    return "";
}

}  // namespace harness::report
