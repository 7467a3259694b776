#include "harness/report/accuracy/summary.h"

#include <algorithm>
#include <cmath>

#include "reference/accuracy/measure/statistics.h"

namespace harness::report {
namespace {

using reference::accuracy::Measurement;
using reference::accuracy::Primitive;
using reference::accuracy::Row;

void set_interval(MethodSummary& method) {
    if (method.rays == 0) return;
    constexpr double million = 1e6;
    const auto share = reference::accuracy::wilson_interval(method.wrong, method.rays);
    method.wrong_per_million = million * static_cast<double>(method.wrong) / static_cast<double>(method.rays);
    method.wrong_low = million * share.low;
    method.wrong_high = million * share.high;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

MethodSummary summary_of(const Row& method, const PrimitiveSummary& primitive, const std::vector<Row>& rows) {
    MethodSummary summary;
    summary.kernel = method.kernel;
    summary.scalar = method.scalar;
    summary.source = method.source;
    summary.gives_t = method.gives_t;
    summary.prepared = method.prepared;
    summary.certain = method.certain;
    double timed = 0;
    double chained = 0;
    double latency = 0;
    double with_t = 0;
    double error = 0;
    for (const Row& row : rows) {
        if (row.primitive != primitive.primitive || row.kernel != method.kernel || row.scalar != method.scalar)
            continue;
        if (!row.hard || primitive.benign.empty()) {
            timed += 1;
            summary.ns += row.ns_per_ray;
            summary.ns_low += row.ns_low;
            summary.ns_high += row.ns_high;
            if (row.latency) {
                chained += 1;
                latency += row.latency->median;
            }
            if (row.t_error) {
                with_t += 1;
                error += row.t_error->mean_ulp;
            }
        }
        if (!row.hard && !primitive.hard.empty()) continue;
        summary.per_set.push_back(row.wrong_per_million);
        summary.rays += row.rays;
        summary.wrong += row.wrong;
        if (row.wrong_per_million <= summary.worst_per_million) continue;
        summary.worst_per_million = row.wrong_per_million;
        summary.worst_set = row.distribution;
    }
    for (double* ns : {&summary.ns, &summary.ns_low, &summary.ns_high}) *ns /= std::max(timed, 1.0);
    if (chained > 0) summary.latency = latency / chained;
    if (with_t > 0) summary.error = error / with_t;
    set_interval(summary);
    return summary;
}

bool beats(const MethodSummary& one, const MethodSummary& other) {
    const bool no_worse = one.ns <= other.ns && one.wrong_per_million <= other.wrong_per_million;
    return no_worse && (one.ns < other.ns || one.wrong_per_million < other.wrong_per_million);
}

void mark_frontier(std::vector<MethodSummary>& methods) {
    for (MethodSummary& one : methods) {
        one.pareto_wrong =
            std::none_of(methods.begin(), methods.end(), [&](const MethodSummary& other) { return beats(other, one); });
    }
}

PrimitiveSummary summary_of(Primitive primitive, const std::vector<Row>& rows) {
    PrimitiveSummary summary{primitive, {}, {}, {}};
    for (const Row& row : rows) {
        std::vector<std::string>& names = row.hard ? summary.hard : summary.benign;
        if (row.primitive == primitive && !contains(names, row.distribution)) names.push_back(row.distribution);
    }
    for (const Row& row : rows) {
        if (row.primitive != primitive) continue;
        const bool known = std::any_of(
            summary.methods.begin(), summary.methods.end(),
            [&](const MethodSummary& method) { return method.kernel == row.kernel && method.scalar == row.scalar; });
        if (!known) summary.methods.push_back(summary_of(row, summary, rows));
    }
    mark_frontier(summary.methods);
    return summary;
}

}  // namespace

std::vector<PrimitiveSummary> summarise(const Measurement& measured) {
    std::vector<PrimitiveSummary> summaries;
    for (const Row& row : measured.rows) {
        const bool known = std::any_of(summaries.begin(), summaries.end(), [&](const PrimitiveSummary& summary) {
            return summary.primitive == row.primitive;
        });
        if (!known) summaries.push_back(summary_of(row.primitive, measured.rows));
    }
    return summaries;
}

std::string method_name(const std::string& kernel, const std::string& scalar) {
    if (scalar.find(kernel) != std::string::npos) return scalar;
    return kernel.find(scalar) != std::string::npos ? kernel : kernel + " " + scalar;
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
