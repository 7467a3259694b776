#include <fmt/format.h>

#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/plot.h"
#include "harness/report/accuracy/report.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

constexpr const char* head = R"(<!DOCTYPE html>
<html xmlns="http://www.w3.org/1999/xhtml" lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>What accuracy costs in time</title>
<style>
body { margin: 0 auto; max-width: 68rem; padding: 0.5rem 1rem; background: #fff; color: #222;
  font: 1rem/1.5 system-ui, Helvetica, Arial, "Liberation Sans", sans-serif; }
h1 { font-size: 1.5rem; margin: 0; }
svg { display: block; width: 100%; height: auto; }
summary { cursor: pointer; font-weight: bold; margin: 0.5rem 0; }
.wide, pre { overflow-x: auto; font-size: 0.85rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.6rem; text-align: right; border-bottom: 1px solid #e4e4e4; vertical-align: bottom; }
th:first-child, .words { text-align: left; font-weight: normal; }
tr.frontier th { font-weight: bold; }
</style>
</head>
<body>
<main>
<h1>What accuracy costs in time</h1>
)";

std::string method_table(const PrimitiveSummary& summary) {
    std::string html = fmt::format(
        "<details>\n<summary>{}: each method, each kind of hard rays</summary>\n<div "
        "class=\"wide\"><table>\n<thead><tr>"
        "<th scope=\"col\">method</th><th scope=\"col\">ns</th><th scope=\"col\">t off, ULP of float</th>"
        "<th scope=\"col\">wrong per million</th>",
        title_of(summary.primitive));
    for (const std::string& set : summary.hard) html += fmt::format("<th scope=\"col\">{}</th>", escape_markup(set));
    html += "<th scope=\"col\" class=\"words\">source</th></tr></thead>\n<tbody>\n";
    for (const MethodSummary& method : summary.methods) {
        const Row& row = method.row;
        html += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>",
                            row.pareto ? " class=\"frontier\"" : "", escape_markup(method_name(row)),
                            three_digits(row.ns_per_ray), row.t_error ? error_text(row.t_error->mean_ulp) : "–",
                            rate_text(row.wrong_per_million));
        for (const double rate : method.per_set) html += fmt::format("<td>{}</td>", rate_text(rate));
        html += fmt::format("<td class=\"words\">{}</td></tr>\n", escape_markup(row.source));
    }
    return html + "</tbody></table></div>\n</details>\n";
}

std::string folded(std::string_view id, std::string_view title, std::string_view text) {
    return fmt::format("<details id=\"{}\">\n<summary>{}</summary>\n<pre>{}</pre>\n</details>\n", id, title,
                       escape_markup(text));
}

}  // namespace

std::string accuracy_html(const AccuracyFindings& findings) {
    const Measurement& measured = findings.measured.value();
    const std::vector<PrimitiveSummary> summaries = summarize(measured);
    std::string html = head + plots(summaries);
    html +=
        "<p>Methods on the left are faster; methods at the bottom are wrong less often. The line joins the methods "
        "that no other method beats in both. Circles compute in float, squares in double. Hard rays aim at what "
        "rounding gets wrong; on ordinary rays every method is right. " +
        busy_note(measured) + "</p>\n";
    html += folded("summary", "The frontier in numbers, and advice", accuracy_text({measured, {}}));
    for (const PrimitiveSummary& summary : summaries) html += method_table(summary);
    if (findings.assignment) html += folded("assignment", "The assignment", assignment_text(*findings.assignment));
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace harness::report
