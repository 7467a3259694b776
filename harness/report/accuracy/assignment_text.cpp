#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/report.h"
#include "harness/report/accuracy/sentences.h"
#include "harness/text/escape.h"

namespace harness::report {

using namespace reference::accuracy;

namespace {

/// Whether all answers in this scalar pass, and all its decisions are right.
bool is_enough(const AssignmentAccuracy& assignment, const std::string& scalar) {
    const auto passes = [&](const ItemAccuracy& item) {
        return std::ranges::none_of(item.errors, [&](const ItemError& error) {
            return error.scalar == scalar && (error.otherwise || error.of_allowance > 1);
        });
    };
    return std::ranges::all_of(assignment.items, passes) &&
           std::ranges::none_of(assignment.decisions, [&](const Decision& decision) {
               return std::ranges::find(decision.wrong, scalar) != decision.wrong.end();
           });
}

/// The share of the allowance that float uses; the largest number if it decides differently.
double used(const ItemAccuracy& item) {
    if (item.errors.empty()) return 0;
    return item.errors.front().otherwise ? HUGE_VAL : item.errors.front().of_allowance;
}

}  // namespace

std::string assignment_text(const AssignmentAccuracy& assignment) {
    const bool in_float = is_enough(assignment, "float"), in_double = is_enough(assignment, "double");
    std::string text = fmt::format("{}\n\nIs float enough? {}\n\n", escape_control(assignment.title),
                                   in_float    ? "Yes: every answer and every decision is right."
                                   : in_double ? "No, but double is."
                                               : "No, and double is not enough either.");
    std::vector<ItemAccuracy> items = assignment.items;
    std::ranges::stable_sort(items, std::greater(), used);
    constexpr std::size_t most_items = 6;
    const std::size_t left_out = items.size() - std::min(items.size(), most_items);
    items.resize(items.size() - left_out);
    text += fmt::format("{:<18}{:>16}{:>16}{:>14}{:>18}\n", "farthest off", "in float", "in double", "allowed",
                        "float uses");
    for (const ItemAccuracy& item : items) {
        std::string line = fmt::format("{:<18}", item_name(item));
        for (const ItemError& error : item.errors)
            line += fmt::format("{:>16}", error.otherwise ? "wrong" : error_text(error.absolute));
        if (item.ulp > 0) line += fmt::format("{:>14}{:>16.1f} %", error_text(item.allowance), 100 * used(item));
        text += line + "\n";
    }
    if (left_out > 0) text += fmt::format("{} other answers use less of their tolerance.\n", left_out);
    text += "\n" + decisions_summary(assignment.decisions) + "\n";
    for (const Decision& decision : assignment.decisions) {
        if (decision.hangs_on_rounding()) text += wrapped("- " + decision_sentence(decision));
    }
    return text;
}

}  // namespace harness::report
