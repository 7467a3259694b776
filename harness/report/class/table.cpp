#include "harness/report/class/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/report/page/templates.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/markup.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

/// Points by question, one cell each; coloured by what is lost.
std::string cells_of(const Graded& graded) {
    std::string cells;
    for (const QuestionScore& question : graded.score.questions) {
        if (graded.execution.outcome == Outcome::not_graded) {
            cells += "<td class=\"number q\">–</td>";
            continue;
        }
        const double points = final_points(graded, question);
        const char* lost = points >= question.max_points ? "" : points > 0 ? " part" : " zero";
        cells += fmt::format("<td class=\"number q{}\">{}</td>", lost, points_text(points));
    }
    return cells;
}

PageData chips_of(const Graded& graded) {
    PageData chips(PageData::type::list);
    const auto add = [&](const std::string& text, const char* kind) {
        PageData chip;
        chip["chip"] = text;
        chip["chip_class"] = kind;
        chips.push_back(chip);
    };
    std::set<std::string> kinds;
    for (const Flag& flag : open_flags(graded)) kinds.insert(flag.kind);
    for (std::string kind : kinds) {
        std::replace(kind.begin(), kind.end(), '_', ' ');
        add(kind, "wrong");
    }
    if (!graded.execution.sanitizer.empty()) add("sanitizer", "missing");
    if (!graded.review.overrides.empty()) add("override", "follow");
    return chips;
}

/// Text that the search finds although the table does not show it: the names of the mistakes.
std::string mistakes_of(const Graded& graded) {
    std::set<std::string> names;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (!item.diagnosis.empty()) names.insert(item.diagnosis);
        }
    }
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : "; ") + name;
    return text;
}

ClassColumns columns_of(const std::vector<Graded>& graded) {
    ClassColumns columns;
    for (const Graded& result : graded) {
        if (label_of(result.submission) != result.submission.id) columns.named = true;
        if (result.submission.lms) columns.dated = true;
    }
    return columns;
}

}  // namespace

std::string late_text(const Graded& graded) {
    return graded.submission.lms && graded.submission.lms->late == true ? "late" : "";
}

std::string Students::links_to(const std::vector<std::size_t>& who) const {
    std::string links;
    for (const std::size_t i : who) {
        links += fmt::format("{}<a href=\"{}\">{}</a>", links.empty() ? "" : ", ", escape_markup(addresses[i]),
                             escape_markup(label_of(graded[i].submission)));
    }
    return links;
}

ClassTable::ClassTable(const Students& students)
    : students_(students), columns_(columns_of(students.graded)), row_(templates::class_row_mustache) {}

std::string ClassTable::row(std::size_t index) {
    const Graded& graded = students_.graded[index];
    PageData data;
    data["outcome"] = std::string(to_string(graded.execution.outcome));
    data["outcome_words"] = outcome_words(graded.execution.outcome);
    data["address"] = students_.addresses[index];
    data["label"] = label_of(graded.submission);
    data["named"] = columns_.named;
    data["id"] = graded.submission.id;
    data["dated"] = columns_.dated;
    data["late"] = late_text(graded);
    data["cells"] = cells_of(graded);
    data["to_review"] = !open_concerns(graded).empty();
    const std::optional<FinalMark> mark = final_mark(graded);
    data["total"] = mark ? points_text(mark->points) : "–";
    data["chips"] = chips_of(graded);
    set_text(data, "mistakes", mistakes_of(graded));
    return row_.fill_in(data);
}

}  // namespace harness::report
