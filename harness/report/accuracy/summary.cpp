#include "harness/report/accuracy/summary.h"

#include <algorithm>

#include "reference/accuracy/measure/statistics.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

bool is_of(const Row& row, const Row& method) {
    return row.primitive == method.primitive && row.kernel == method.kernel && row.scalar == method.scalar;
}

MethodSummary summary_of(const Row& method, const PrimitiveSummary& primitive, const std::vector<Row>& rows) {
    MethodSummary summary{method, {}};
    std::uint64_t rays = 0;
    std::uint64_t wrong = 0;
    for (const Row& row : rows) {
        if (!is_of(row, method)) continue;
        if (!row.hard) summary.row = row;
        if (!row.hard && !primitive.hard.empty()) continue;
        summary.per_set.push_back(row.wrong_per_million);
        rays += row.rays;
        wrong += row.wrong;
    }
    if (rays > 0) set_wrong(summary.row, wrong, rays);
    return summary;
}

/// `first` is the primitive's first row; the first distribution's rows name the methods.
PrimitiveSummary summary_of(const Row& first, const std::vector<Row>& rows) {
    PrimitiveSummary summary{first.primitive, {}, {}};
    for (const Row& row : rows) {
        if (row.hard && is_of(row, first)) summary.hard.push_back(row.distribution);
    }
    std::vector<Row> totals;
    for (const Row& row : rows) {
        if (row.primitive != first.primitive || row.distribution != first.distribution) continue;
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
        if (summaries.empty() || summaries.back().primitive != row.primitive)
            summaries.push_back(summary_of(row, measured.rows));
    }
    return summaries;
}

std::vector<Row> frontier(const PrimitiveSummary& summary) {
    constexpr std::size_t most = 3;
    std::vector<Row> rows;
    for (const MethodSummary& method : summary.methods) {
        if (method.row.pareto) rows.push_back(method.row);
    }
    std::ranges::stable_sort(rows, {}, &Row::ns_per_ray);
    while (rows.size() > most) {
        std::size_t least = 1;
        const auto saved = [&](std::size_t i) { return rows[i + 1].ns_per_ray / rows[i].ns_per_ray; };
        for (std::size_t i = 2; i + 1 < rows.size(); ++i) {
            if (saved(i) < saved(least)) least = i;
        }
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(least));
    }
    return rows;
}

std::string method_name(const Row& row) {
    return row.kernel + " " + row.scalar;
}

std::string title_of(Primitive primitive) {
    return primitive == Primitive::cast ? "The whole cast" : "Ray and " + name_of(primitive);
}

}  // namespace harness::report
