#include "harness/report/text/changed_feedback.h"

#include <fmt/format.h>

#include "harness/report/text/columns.h"

namespace harness::report {
namespace {

std::string part_text(const PartChange& change) {
    std::string text = one_line(change.part);
    const char* comma = " ";
    const auto add = [&](std::size_t count, std::string_view words) {
        if (count == 0) return;
        text += fmt::format("{}{} {}", comma, words, count);
        comma = ", ";
    };
    add(change.fresh, "new in");
    add(change.other, "changed in");
    add(change.gone, "gone from");
    if (change.gone > 0 && !change.option.empty()) text += fmt::format(" (see {})", change.option);
    return text;
}

}  // namespace

std::string feedback_changes_text(const FeedbackChanges& changes) {
    std::string text;
    for (const PartChange& change : changes.parts) text += (text.empty() ? "" : "; ") + part_text(change);
    if (changes.remeasured > 0) {
        text += fmt::format("{}only time and memory in {}", text.empty() ? "" : "; ", changes.remeasured);
    }
    return text.empty() ? "" : fmt::format("Apart from the marks, by number of submissions: {}.\n", text);
}

}  // namespace harness::report
