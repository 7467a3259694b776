#include <fmt/format.h>

#include "harness/report/accuracy/assignment.h"
#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/sentences.h"
#include "harness/text/markup.h"

namespace harness::report {
namespace {

using namespace reference::accuracy;

std::string item_row(const ItemAccuracy& item) {
    std::string row = fmt::format("<tr><th scope=\"row\">{}</th><td class=\"words\">{}</td>",
                                  escape_markup(item_name(item)), escape_markup(item.truth));
    for (const ItemError& error : item.errors) {
        const std::string cell = item.ulp > 0 || error.otherwise ? error_cell(error) : "right";
        const bool is_bad = error.otherwise || error.of_allowance > 1;
        row += fmt::format("<td{}>{}</td>", is_bad ? " class=\"bad\"" : "", escape_markup(cell));
    }
    if (item.ulp == 0 || item.errors.empty()) return row + "<td></td><td></td><td></td></tr>\n";
    const ItemError& error = item.errors.front();
    return row + fmt::format("<td>{}</td><td>{}</td><td>{:.1f} %</td></tr>\n", error_text(error.absolute),
                             error_text(item.allowance), 100 * error.of_allowance);
}

}  // namespace

std::string assignment_html(const AssignmentAccuracy& assignment) {
    std::string html =
        fmt::format("<section id=\"assignment\">\n<h2>The assignment: {}</h2>\n", escape_markup(assignment.title));
    html += "<h3>Which decisions hang on rounding</h3>\n<p>" + escape_markup(decisions_summary(assignment.decisions)) +
            "</p>\n";
    std::string near;
    for (const Decision& one : assignment.decisions) {
        if (one.hangs_on_rounding()) near += "<li>" + escape_markup(decision_sentence(one)) + "</li>\n";
    }
    if (!near.empty()) html += "<ul>\n" + near + "</ul>\n";
    html +=
        "<h3>How far each answer is off</h3>\n<p>The handout's answers, computed in each type, against the "
        "certified answers: the largest error over an item's components, in units in the last place of float (ULP), "
        "then "
        "float's error as a length, what marking forgives, and how much of that float uses.</p>\n"
        "<div class=\"wide\"><table>\n<thead><tr><th scope=\"col\">item</th><th scope=\"col\">true value</th>"
        "<th scope=\"col\">float</th><th scope=\"col\">double</th>"
        "<th scope=\"col\">float, off by</th><th scope=\"col\">allowance</th><th scope=\"col\">used</th></tr></thead>\n"
        "<tbody>\n";
    for (const ItemAccuracy& item : assignment.items) html += item_row(item);
    return html + "</tbody></table></div>\n</section>\n";
}

}  // namespace harness::report
