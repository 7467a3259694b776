#include <fmt/format.h>

#include <algorithm>

#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/report.h"
#include "harness/report/accuracy/sentences.h"
#include "harness/report/accuracy/summary.h"
#include "harness/text/escape.h"
#include "harness/text/listed.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

std::string range(double low, double high, std::string (*in_words)(double)) {
    return fmt::format("({}–{})", in_words(low), in_words(high));
}

/// The ratio of a method's time to the fastest, from the quartiles of both.
std::string times(const Row& row, const Row& fastest) {
    return fmt::format("{:.2f} ({:.2f}–{:.2f})", row.ns_per_ray / fastest.ns_per_ray, row.ns_low / fastest.ns_high,
                       row.ns_high / fastest.ns_low);
}

std::string frontier_text(const PrimitiveSummary& summary) {
    std::string text;
    const std::vector<Row> rows = frontier(summary);
    for (const Row& row : rows) {
        text += fmt::format("{:<9} {:<35} {:>5} {:<13} {:<18} {:>8} {}\n", name_of(summary.primitive),
                            escape_control(method_name(row)), three_digits(row.ns_per_ray),
                            range(row.ns_low, row.ns_high, three_digits), times(row, rows.front()),
                            rate_text(row.wrong_per_million), range(row.wrong_low, row.wrong_high, rate_text));
    }
    return text;
}

std::string advice(const std::vector<PrimitiveSummary>& summaries) {
    std::vector<std::string> parts;
    for (const PrimitiveSummary& summary : summaries) {
        const std::vector<Row> rows = frontier(summary);
        if (rows.back().certain)
            parts.push_back(fmt::format("{}{} for a {}", times(rows.back(), rows.front()),
                                        parts.empty() ? " times as long as the fastest formula" : "",
                                        name_of(summary.primitive)));
    }
    if (parts.empty()) return "";
    return fmt::format("Compute in double. If every pixel matters, decide exactly, which takes {}.", listed(parts));
}

/// How it was measured, and whether the machine was busy; two or three lines.
std::string run_facts(const Measurement& measured) {
    return fmt::format(
               "In brackets: quartiles of {} repetitions, 95 % interval of wrong decisions. Seed {}, {} rays of each "
               "kind.\n"
               "{}{}, {}.\n",
               measured.repetitions, measured.seed, measured.rays,
               measured.processor.empty() ? "" : escape_control(measured.processor) + ", ",
               escape_control(measured.compiler), escape_control(measured.flags)) +
           busy_note(measured);
}

std::string measured_text(const Measurement& measured) {
    const std::vector<PrimitiveSummary> summaries = summarize(measured);
    std::string text = fmt::format(
        "The cost of accuracy: the methods that no other method beats in both time and wrong decisions\n\n"
        "{:<9} {:<35} {:<19} {:<18} {}\n",
        "", "", "ns/ray", "times the fastest", "wrong per million hard rays");
    for (const PrimitiveSummary& summary : summaries) text += frontier_text(summary);
    text += "\n" + wrapped(advice(summaries));
    const auto& [in_float, in_double, certified] = measured.key_ms;
    if (certified.median > 0) {
        const auto ms = [](const Quartiles& key) {
            return fmt::format("{} ms {}", three_digits(key.median), range(key.low, key.high, three_digits));
        };
        text += fmt::format("One key takes {} in float, {} in double and {} certified.\n", ms(in_float), ms(in_double),
                            ms(certified));
    }
    return text + run_facts(measured);
}

}  // namespace

std::string busy_note(const Measurement& measured) {
    constexpr double quiet = 0.5;
    if (measured.load <= quiet) return "";
    return fmt::format("The machine was busy (load {:.1f}). Measure again when it is idle.\n", measured.load);
}

std::string accuracy_text(const AccuracyFindings& findings) {
    std::string text;
    if (findings.assignment) text += assignment_text(*findings.assignment);
    if (findings.assignment && findings.measured) text += "\n";
    if (findings.measured) text += measured_text(*findings.measured);
    return text;
}

}  // namespace harness::report
