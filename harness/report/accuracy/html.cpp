#include <fmt/format.h>

#include "harness/report/accuracy/assignment.h"
#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/plot.h"
#include "harness/report/accuracy/price.h"
#include "harness/report/accuracy/report.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

constexpr const char* style = R"(
:root { color-scheme: light; }
body { margin: 0 auto; max-width: 68rem; padding: 1rem; background: #fff; color: #222;
  font: 1rem/1.5 system-ui, Helvetica, Arial, "Liberation Sans", sans-serif; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { margin: 2.5rem 0 0.5rem; border-bottom: 2px solid #ddd; }
h3 { margin: 1.5rem 0 0.25rem; }
p, li { max-width: 46rem; }
a { color: #0062a0; }
figure { margin: 0.5rem 0 1rem; display: grid; gap: 0.5rem; align-items: start;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); }
summary { cursor: pointer; font-weight: bold; margin: 0.75rem 0; }
.price { font-size: 1.2rem; font-weight: bold; }
.picture { overflow-x: auto; }
.picture svg { display: block; width: 100%; min-width: 24rem; max-width: 42rem; height: auto; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td { padding: 0.2rem 0.6rem; text-align: right; border-bottom: 1px solid #e4e4e4;
  font-variant-numeric: tabular-nums; vertical-align: top; }
th[scope="row"], th:first-child, .words { text-align: left; font-weight: normal; }
thead th { border-bottom: 2px solid #999; vertical-align: bottom; }
tr.frontier th { font-weight: bold; }
pre { overflow-x: auto; font-size: 0.8rem; }
.facts { color: #555; font-size: 0.9rem; }
@page { size: A4; margin: 12mm; }
@media print {
  :root { font-size: 9.5pt; }
  body { max-width: none; padding: 0; }
  figure { grid-template-columns: 1fr 1fr; }
  .picture svg { min-width: 0; }
  .picture, .wide { overflow: visible; }
  table { font-size: 8pt; }
  th, td { padding: 0.1rem 0.35rem; }
  .picture, tr, li { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
}
)";

constexpr const char* introduction = R"(
<p>A ray tracer asks one question millions of times: does this ray hit, and where? The formula is in every textbook, and in a
computer's arithmetic it sometimes answers wrongly. Here every method got the same rays, was timed in the same run, and each of
its answers was judged by exact arithmetic, which does not round. <strong>Further left is faster, further down is wrong less
often.</strong></p>
)";

constexpr const char* reading_aid = R"(
<details>
<summary>How to read the pictures</summary>
<ul>
<li>Each mark is a method: a circle computes in float, a square in double. The legend below gives the name by
the number beside the mark; methods that lie close together share a label. A tooltip shows a mark's figures.</li>
<li>Wrong means a hit taken for a miss, a miss for a hit, or the wrong order of two hits. A mark in the green band made no wrong
decision at all; its height within the band means nothing: the fastest is on top.</li>
<li>The stepped line is the frontier. No other method beats a method on it, in bold, in both at once; whatever lies above
the line and to its right costs more or errs more than it needs to.</li>
<li>Benign rays are those of a usual picture. Hard rays aim at what rounding gets wrong, such as spheres just grazed and edges
just met; their rate says how a method fails where it matters, not how often it fails in a picture.</li>
</ul>
</details>
)";

std::string plots(const std::vector<PrimitiveSummary>& summaries) {
    std::string html = "<section id=\"summary\">\n<figure>\n";
    for (const PrimitiveSummary& summary : summaries) html += "<div class=\"picture\">\n" + plot(summary) + "</div>\n";
    return html + "</figure>\n</section>\n";
}

/// As the text shows it.
std::string assignment_section(const AssignmentAccuracy& assignment) {
    return fmt::format("<section id=\"assignment\">\n<h2>The assignment: {}</h2>\n<pre>{}</pre>\n</section>\n",
                       escape_markup(assignment.title), escape_markup(assignment_text(assignment)));
}

std::string method_table(const PrimitiveSummary& summary) {
    std::string html = fmt::format(
        "<details>\n<summary>{}: the methods and where they are from</summary>\n<p>Time and error of t (mean, in units "
        "in "
        "the last place of float) are those of benign rays. Wrong decisions are per million hard rays: the mean of all "
        "sets, then each set. Bold: on the frontier.</p>\n<div class=\"wide\"><table>\n<thead><tr><th "
        "scope=\"col\">method</th><th scope=\"col\">ns</th><th scope=\"col\">t off, ULP</th><th scope=\"col\">wrong "
        "per "
        "million</th>",
        title_of(summary.primitive));
    for (const std::string& set : summary.hard) html += fmt::format("<th scope=\"col\">{}</th>", escape_markup(set));
    html += "<th scope=\"col\" class=\"words\">source</th></tr></thead>\n<tbody>\n";
    for (const MethodSummary& method : summary.methods) {
        const Row& row = method.row;
        html += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>",
                            row.pareto_wrong ? " class=\"frontier\"" : "", escape_markup(method_name(row)),
                            three_digits(row.ns_per_ray), row.t_error ? error_text(row.t_error->mean_ulp) : "–",
                            rate_text(row.wrong_per_million));
        if (!summary.hard.empty()) {
            for (const double rate : method.per_set) html += fmt::format("<td>{}</td>", rate_text(rate));
        }
        html += fmt::format("<td class=\"words\">{}</td></tr>\n", escape_markup(row.source));
    }
    return html + "</tbody></table></div>\n</details>\n";
}

std::string run_facts(const Measurement& measured) {
    return fmt::format(
        "<p class=\"facts\">Seed {}, {} rays of each distribution, median of {} interleaved repetitions. Compiler: {}. "
        "Flags: {}. Processor: {}. Every figure is in accuracy.json beside this page.</p>\n",
        measured.seed, measured.rays, measured.repetitions, escape_markup(measured.compiler),
        escape_markup(measured.flags),
        measured.processor.empty() ? "not named by the machine" : escape_markup(measured.processor));
}

}  // namespace

std::string accuracy_html(const AccuracyFindings& findings) {
    const Measurement& measured = findings.measured.value();
    const std::vector<PrimitiveSummary> summaries = summarize(measured);
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<title>What accuracy costs in time</title>\n<style>{}</style>\n</head>\n<body>\n<header>\n"
        "<h1>What accuracy costs in time</h1>\n",
        style);
    if (const std::string sentence = price_sentence(prices(measured)); !sentence.empty()) {
        html += fmt::format("<p class=\"price\">{}</p>\n", escape_markup(sentence));
    }
    html += fmt::format("{}</header>\n<main>\n", introduction);
    html += plots(summaries) + run_facts(measured) + reading_aid;
    for (const PrimitiveSummary& summary : summaries) html += method_table(summary);
    if (findings.assignment) html += assignment_section(*findings.assignment);
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace harness::report
