#include <fmt/format.h>
#include <fmt/ranges.h>

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

constexpr std::size_t widest_name = 36;

std::string shown_name(const Row& row) {
    return escape_control(method_name(row));
}

/// The width for a group's names; longer names push their line to the right.
std::size_t name_width(const std::vector<std::string>& names) {
    std::size_t width = std::string_view("method").size();
    for (const std::string& name : names) width = std::max(width, fmt::formatted_size("{:<1}", name));
    return std::min(width, widest_name);
}

std::string summary_table(const PrimitiveSummary& summary) {
    std::vector<std::string> names;
    for (const MethodSummary& method : summary.methods) names.push_back(shown_name(method.row));
    const std::size_t width = name_width(names);
    std::string text =
        fmt::format("{}: {} benign and {} hard distributions\n", escape_control(title_of(summary.primitive)),
                    summary.benign.size(), summary.hard.size());
    if (!summary.hard.empty()) {
        text += wrapped("wrong per million: the mean of " +
                        escape_control(fmt::format("{}", fmt::join(summary.hard, ", "))));
    }
    text += "\n";
    text += fmt::format("  {:<{}}  {:>9}  {:>12}  {:>13}\n", "", width, "benign", "benign", "hard: wrong");
    text += fmt::format("  {:<{}}  {:>9}  {:>12}  {:>13}  {}\n", "method", width, "ns/ray", "t off, ULP", "per million",
                        "worst set");
    for (std::size_t i = 0; i < names.size(); ++i) {
        const MethodSummary& method = summary.methods[i];
        const Row& row = method.row;
        const std::string worst = method.worst_set.empty() ? "-"
                                                           : fmt::format("{} {}", escape_control(method.worst_set),
                                                                         rate_text(method.worst_per_million));
        text += fmt::format("{} {:<{}}  {:>9}  {:>12}  {:>13}  {}\n", row.pareto_wrong ? "*" : " ", names[i], width,
                            three_digits(row.ns_per_ray), row.t_error ? error_text(row.t_error->mean_ulp) : "-",
                            rate_text(row.wrong_per_million), worst);
    }
    return text + "\n";
}

std::string panel_table(const Panel& panel) {
    std::vector<std::string> names;
    for (const Row* row : panel.rows) names.push_back(shown_name(*row));
    const std::size_t width = name_width(names);
    std::string text = fmt::format("{}, {}{}\n\n", escape_control(title_of(panel.primitive)),
                                   escape_control(panel.distribution), panel.hard ? " (hard)" : "");
    text += fmt::format("  {:<{}}  {:>8} {:>15}  {:>9} {:>15}  {:>8} {:>8} {:>8}\n", "method", width, "ns/ray",
                        "quartiles", "wrong/1e6", "95 % interval", "mean ULP", "99 %", "max");
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Row& row = *panel.rows[i];
        const auto error = [&](double TError::*which) {
            return row.t_error ? error_text((*row.t_error).*which) : std::string("-");
        };
        text += fmt::format(
            "{} {:<{}}  {:>8} {:>15}  {:>9} {:>15}  {:>8} {:>8} {:>8}\n", row.pareto_wrong ? "*" : " ", names[i], width,
            three_digits(row.ns_per_ray), fmt::format("{}–{}", three_digits(row.ns_low), three_digits(row.ns_high)),
            rate_text(row.wrong_per_million), fmt::format("{}–{}", rate_text(row.wrong_low), rate_text(row.wrong_high)),
            error(&TError::mean_ulp), error(&TError::p99_ulp), error(&TError::max_ulp));
    }
    return text + "\n";
}

std::string price_table(const std::vector<Price>& all) {
    if (all.empty()) return "";
    std::string text = wrapped(price_sentence(all)) + "\n";
    text += fmt::format("  {:<40}  {:>7}  {:>8}  {:<28}  {:>5}  {:>9}  {:>5}\n", "what", "certain", "rounding",
                        "fastest that rounds", "times", "quartiles", "chain");
    for (const Price& price : all) {
        text += fmt::format("  {:<40}  {:>7}  {:>8}  {:<28}  {:>5.2f}  {:>9}  {:>5}\n",
                            name_of(price.primitive) + ": " + shape_text(price), three_digits(price.ns.median),
                            three_digits(price.rival_ns.median), escape_control(price.rival), price.times(),
                            fmt::format("{:.2f}–{:.2f}", price.least_times(), price.most_times()),
                            price.times_in_a_chain ? fmt::format("{:.2f}", *price.times_in_a_chain) : "-");
    }
    return text + "\n";
}

std::string measured_text(const Measurement& measured, Extent extent) {
    std::string text = fmt::format("seed {}, {} rays of each distribution, {} interleaved repetitions{}\n{}, {}\n",
                                   measured.seed, measured.rays, measured.repetitions,
                                   measured.processor.empty() ? "" : ", " + escape_control(measured.processor),
                                   escape_control(measured.compiler), escape_control(measured.flags));
    text += price_table(prices(measured));
    text += "* no method measured here is at once faster and less often wrong; `t off`: mean error of right hits\n\n";
    for (const PrimitiveSummary& summary : summarize(measured)) text += summary_table(summary);
    if (extent == Extent::all)
        for (const Panel& panel : panels_of(measured)) text += panel_table(panel);
    text.pop_back();
    return text;
}

}  // namespace

std::string accuracy_text(const AccuracyFindings& findings, Extent extent) {
    std::string text;
    if (findings.assignment) text += assignment_text(*findings.assignment);
    if (findings.assignment && findings.measured) text += "\n";
    if (findings.measured) text += measured_text(*findings.measured, extent);
    return text;
}

}  // namespace harness::report
