#include <fmt/format.h>

#include <algorithm>

#include "harness/report/accuracy/assignment.h"
#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/sentences.h"
#include "harness/text/escape.h"

namespace harness::report {

using namespace reference::accuracy;

std::string assignment_text(const AssignmentAccuracy& assignment) {
    std::string text = fmt::format("{}\n\n", escape_control(assignment.title));
    text +=
        "How far a right program's answers are from the true ones, in units in the last place of float (ULP); the\n"
        "largest over an item's components. The allowance is what marking forgives, and the last column the share\n"
        "of it that float uses.\n\n";
    text += fmt::format("  {:<16} {:>12} {:>12} {:>14} {:>12} {:>9}\n", "item", "float", "double", "float, off by",
                        "allowance", "used");
    for (const ItemAccuracy& item : assignment.items) {
        std::string line = fmt::format("  {:<16}", item_name(item));
        for (const ItemError& error : item.errors)
            line += fmt::format(" {:>12}", item.ulp > 0 || error.otherwise ? error_cell(error) : "right");
        if (item.ulp > 0 && !item.errors.empty()) {
            const ItemError& error = item.errors.front();
            line += fmt::format(" {:>14} {:>12} {:>9}", error_text(error.absolute), error_text(item.allowance),
                                fmt::format("{:.1f} %", 100 * error.of_allowance));
        }
        text += line + "\n";
    }
    text += "\n" + decisions_summary(assignment.decisions) + "\n";
    for (const Decision& decision : assignment.decisions) {
        if (decision.hangs_on_rounding()) text += wrapped("- " + decision_sentence(decision));
    }
    return text;
}

}  // namespace harness::report
