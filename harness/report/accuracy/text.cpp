#include <fmt/format.h>

#include <algorithm>

#include "harness/report/accuracy/assignment.h"
#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/price.h"
#include "harness/report/accuracy/report.h"
#include "harness/report/accuracy/sentences.h"
#include "harness/report/accuracy/summary.h"
#include "harness/text/escape.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

/// The methods on the frontier, from the fastest to the one that is wrong least often.
std::string frontier_of(const PrimitiveSummary& summary) {
    std::vector<Row> rows;
    for (const MethodSummary& method : summary.methods) {
        if (method.row.pareto_wrong) rows.push_back(method.row);
    }
    std::ranges::stable_sort(rows, {}, &Row::ns_per_ray);
    std::string text = title_of(summary.primitive) + "\n";
    for (const Row& row : rows) {
        text += fmt::format("  {:<40}  {:>7}  {:>9.2f}  {:>17}\n", escape_control(method_name(row)),
                            three_digits(row.ns_per_ray), row.ns_per_ray / rows.front().ns_per_ray,
                            rate_text(row.wrong_per_million));
    }
    return text;
}

std::string measured_text(const Measurement& measured) {
    std::string text = fmt::format(
        "What accuracy costs: the methods that no other method beats in both time and wrong decisions\n\n  {:<40}  "
        "{:>7}  {:>9}  {:>17}\n",
        "", "ns/ray", "× fastest", "wrong per million");
    for (const PrimitiveSummary& summary : summarize(measured)) text += frontier_of(summary);
    const std::string advice = price_sentence(prices(measured));
    if (!advice.empty()) text += "\n" + wrapped(advice);
    return text + fmt::format(
                      "\nTimes of benign rays, wrong decisions on hard rays. Seed {}, {} rays of each "
                      "distribution, {} repetitions.\n{}{}, {}\n",
                      measured.seed, measured.rays, measured.repetitions,
                      measured.processor.empty() ? "" : escape_control(measured.processor) + ", ",
                      escape_control(measured.compiler), escape_control(measured.flags));
}

}  // namespace

std::string accuracy_text(const AccuracyFindings& findings) {
    std::string text;
    if (findings.assignment) text += assignment_text(*findings.assignment);
    if (findings.assignment && findings.measured) text += "\n";
    if (findings.measured) text += measured_text(*findings.measured);
    return text;
}

}  // namespace harness::report
