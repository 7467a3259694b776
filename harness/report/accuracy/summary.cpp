#include "harness/report/accuracy/summary.h"

#include <algorithm>
#include <cmath>

#include "reference/accuracy/measure/statistics.h"

namespace harness::report {
namespace {

using reference::accuracy::Measurement;
using reference::accuracy::Primitive;
using reference::accuracy::Row;

/// The mean of the numbers that were added.
class Mean {
  public:
    void add(double number) {
        sum_ += number;
        count_ += 1;
    }
    std::optional<double> value() const { return count_ == 0 ? std::nullopt : std::optional(sum_ / count_); }

  private:
    double sum_ = 0;
    double count_ = 0;
};

void set_interval(MethodSummary& method) {
    if (method.rays == 0) return;
    constexpr double million = 1e6;
    const auto share = reference::accuracy::wilson_interval(method.wrong, method.rays);
    method.wrong_per_million = million * static_cast<double>(method.wrong) / static_cast<double>(method.rays);
    method.wrong_low = million * share.low;
    method.wrong_high = million * share.high;
}

void add_wrong(MethodSummary& summary, const Row& row) {
    summary.per_set.push_back(row.wrong_per_million);
    summary.rays += row.rays;
    summary.wrong += row.wrong;
    if (row.wrong_per_million <= summary.worst_per_million) return;
    summary.worst_per_million = row.wrong_per_million;
    summary.worst_set = row.distribution;
}

MethodSummary summary_of(const Row& method, const PrimitiveSummary& primitive, const std::vector<Row>& rows) {
    MethodSummary summary{method.kernel, method.scalar, method.source};
    summary.gives_t = method.gives_t;
    summary.certain = method.certain;
    Mean ns, ns_low, ns_high, latency, error;
    for (const Row& row : rows) {
        if (row.primitive != primitive.primitive || row.kernel != method.kernel || row.scalar != method.scalar)
            continue;
        if (row.hard || primitive.hard.empty()) add_wrong(summary, row);
        if (row.hard && !primitive.benign.empty()) continue;
        ns.add(row.ns_per_ray);
        ns_low.add(row.ns_low);
        ns_high.add(row.ns_high);
        if (row.latency) latency.add(row.latency->median);
        if (row.t_error) error.add(row.t_error->mean_ulp);
    }
    summary.ns = ns.value().value_or(0);
    summary.ns_low = ns_low.value().value_or(0);
    summary.ns_high = ns_high.value().value_or(0);
    summary.latency = latency.value();
    summary.error = error.value();
    set_interval(summary);
    return summary;
}

bool beats(const MethodSummary& rival, const MethodSummary& method) {
    const bool no_worse = rival.ns <= method.ns && rival.wrong_per_million <= method.wrong_per_million;
    return no_worse && (rival.ns < method.ns || rival.wrong_per_million < method.wrong_per_million);
}

PrimitiveSummary summary_of(Primitive primitive, const std::vector<Row>& rows) {
    PrimitiveSummary summary{primitive, {}, {}, {}};
    for (const Row& row : rows) {
        std::vector<std::string>& names = row.hard ? summary.hard : summary.benign;
        const bool is_known = std::find(names.begin(), names.end(), row.distribution) != names.end();
        if (row.primitive == primitive && !is_known) names.push_back(row.distribution);
    }
    std::vector<MethodSummary>& methods = summary.methods;
    for (const Row& row : rows) {
        const bool is_known = std::any_of(methods.begin(), methods.end(), [&](const MethodSummary& method) {
            return method.kernel == row.kernel && method.scalar == row.scalar;
        });
        if (row.primitive == primitive && !is_known) methods.push_back(summary_of(row, summary, rows));
    }
    for (MethodSummary& method : methods) {
        method.pareto_wrong = std::none_of(methods.begin(), methods.end(),
                                           [&](const MethodSummary& rival) { return beats(rival, method); });
    }
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

std::string method_name(const std::string& kernel, const std::string& scalar) {
    return kernel + " " + scalar;
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
