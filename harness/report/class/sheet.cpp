#include "harness/report/class/sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/class/statistics.h"
#include "harness/report/class/table.h"
#include "harness/report/page/templates.h"
#include "harness/report/picture/picture.h"
#include "harness/report/text/expected_text.h"
#include "harness/report/text/look_first.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/markup.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

/// Limit for each text of a submission; the student's page has all of it.
constexpr std::size_t most_text_bytes = 4 << 10U;

/// Limit for all pictures together, so that a report on a thousand students opens quickly. Later students have their
/// picture only on their own page.
constexpr std::size_t most_picture_bytes = 1 << 20U;

/// Limit for all outputs and sources together, for the same reason. The gradebook has the rest.
constexpr std::size_t most_listing_bytes = 3 << 20U;

std::string question_heading(const Graded& graded, const QuestionScore& question) {
    const double points = final_points(graded, question);
    const bool set = find_override(graded, question.number, "") != nullptr;
    return fmt::format(
        "<tbody><tr class=\"question\"><th colspan=\"4\" scope=\"rowgroup\">{}. {}</th><td class=\"number\">{}{} of "
        "{}</td></tr>\n",
        question.number, escape_markup(question.title),
        set ? fmt::format("<s>{}</s> ", points_text(question.points)) : "", points_text(points),
        points_text(question.max_points));
}

/// The reason for a lost item, for the instructor: the student's sentence, the mistake's name, the distance, and how
/// the answer was found.
std::string why_of(const ItemScore& item, Outcome outcome) {
    if (item.verdict == ItemVerdict::missing) return item.experiment;  // the verdict says the rest
    std::string why = item_sentence(item, outcome);
    if (!item.diagnosis.empty()) why += fmt::format(" ({})", item.diagnosis);
    const bool off = item.error && item.verdict != ItemVerdict::right;
    if (off) why += fmt::format(" Off by {:.3g}", *item.error);
    if (off) why += item.allowance ? fmt::format("; {:.2g} is allowed.", *item.allowance) : ".";
    for (const std::string& note : {item.reread, item.experiment})
        if (!note.empty()) why += (why.empty() ? "" : " ") + note;
    return why;
}

/// Notes on lines of the source: the compiler's messages, and printed answers that are typed in as constants.
LineNotes notes_of_source(const Graded& graded) {
    LineNotes notes = notes_of_compiler(compiler_messages(graded.execution.build.diagnostics));
    for (const Flag& flag : graded.findings.flags) {
        if (flag.kind != "hard_coded") continue;
        for (const int line : lines_named(flag.evidence)) notes[line].push_back({"printed as a constant", "wrong"});
    }
    return notes;
}

bool lost_geometry(const Graded& graded) {
    return std::any_of(graded.score.questions.begin(), graded.score.questions.end(), [](const QuestionScore& question) {
        return std::any_of(question.items.begin(), question.items.end(), [](const ItemScore& item) {
            return item.verdict == ItemVerdict::wrong || item.verdict == ItemVerdict::follow;
        });
    });
}

std::string_view why_it_does_not_count(const Graded& graded, const Override& given) {
    if (!points_at(graded.score, given)) return " (the rubric no longer has these points)";
    const bool counts = find_override(graded, given.question, given.item) == &given;
    return counts ? "" : " (a later override counts)";
}

PageData changes_of(const Graded& graded, const std::optional<FinalMark>& mark) {
    PageData changes(PageData::type::list);
    const auto add = [&](const std::string& text, const std::string& when = "", const std::string& why = "") {
        PageData change;
        change["text"] = text;
        set_text(change, "when", when);
        set_text(change, "why", why);
        changes.push_back(change);
    };
    if (graded.score.variants && graded.execution.outcome != Outcome::not_graded) add(scenes_sentence(graded));
    for (const Override& given : graded.review.overrides) {
        add(fmt::format("Override: {} points for {}, by {}", points_text(given.points), place_in_words(place_of(given)),
                        given.by),
            given.when, fmt::format("{}{}", given.why, why_it_does_not_count(graded, given)));
    }
    if (mark && mark->late_deduction > 0)
        add(fmt::format("Late: {} points are taken off.", points_text(mark->late_deduction)));
    const bool marked = graded.execution.outcome != Outcome::not_graded;
    if (mark && marked && points_text(mark->points) != points_text(graded.score.points))
        add(fmt::format("Automatic mark: {} of {} points.", points_text(graded.score.points),
                        points_text(graded.score.max_points)));
    if (graded.score.follow_cap && marked) add(cap_sentence(*graded.score.follow_cap));
    for (const Decision& decision : graded.review.decisions) {
        if (decision.kind == Decision::Kind::points) continue;  // its override is above
        add(fmt::format("{}, by {}", decision_in_words(decision), decision.by), decision.when, decision.text);
    }
    return changes;
}

std::string facts_of(const Graded& graded) {
    const Submission& submission = graded.submission;
    std::string facts = label_of(submission) == submission.id ? "" : submission.id + " · ";
    const std::string file = submission.file.string();
    if (!file.empty()) facts += file + " · ";
    facts += outcome_words(graded.execution.outcome);
    if (!late_text(graded).empty()) facts += " · late";
    return facts;
}

}  // namespace

ClassSheets::ClassSheets(const Marking& marking)
    : marking_(marking),
      asked_(expected_texts(marking.key)),
      sheet_(templates::class_student_mustache),
      item_(templates::class_item_mustache) {}

std::string ClassSheets::rows_of(const Graded& graded, const QuestionScore& question, const ExpectedTexts& asked,
                                 const Listing& printout) {
    std::string rows = question_heading(graded, question);
    for (const ItemScore& item : question.items) {
        PageData data;
        data["name"] = name_in_question(item.spec);
        set_text(data, "printed", item.printed);
        if (item.line != 0) data["line"] = printout.with_links(fmt::format("line {}", item.line));
        data["asked"] = asked.at(item.spec.id).beside(item);
        data["verdict"] = std::string(to_string(item.verdict));
        data["word"] = std::string(word_of(item.verdict));
        data["got"] = points_text(final_points(graded, question, item));
        data["most"] = points_text(item.max_points);
        if (find_override(graded, question.number, std::string(item.spec.name)) != nullptr)
            data["automatic"] = points_text(item.points);
        set_text(data, "why", why_of(item, graded.execution.outcome));
        rows += item_.fill_in(data);
    }
    return rows + "</tbody>\n";
}

ListingBounds ClassSheets::bounds_left() const {
    return listing_bytes_ < most_listing_bytes ? ListingBounds{} : ListingBounds{0, 0};
}

std::string ClassSheets::picture_of(const Graded& graded, std::size_t index) {
    if (picture_bytes_ > most_picture_bytes || !lost_geometry(graded)) return "";
    std::string picture = explaining_picture(own_marking(marking_, graded.submission), &graded, /*with_answers=*/true,
                                             fmt::format("p{}-", index + 1));
    picture_bytes_ += picture.size();
    return picture;
}

std::string ClassSheets::sheet(const Graded& graded, std::size_t index) {
    PageData data;
    data["number"] = std::to_string(index + 1);
    data["label"] = label_of(graded.submission);
    data["facts"] = facts_of(graded);
    data["outcome_words"] = outcome_words(graded.execution.outcome);
    const std::optional<FinalMark> mark = final_mark(graded);
    if (mark) data["total"] = points_text(mark->points);
    data["max"] = points_text(graded.score.max_points);
    const std::string& source_text = graded.submission.source;
    const std::string prefix = fmt::format("s{}-", index + 1);
    const Listing printout =
        Listing::of_printout(shown_printout(graded), notes_of_answers(graded.score), prefix + "o", bounds_left());
    const Listing source = Listing::of_source(source_text, notes_of_source(graded), prefix + "c", bounds_left());
    if (!graded.execution.explanation.empty()) data["explanation"] = printout.with_links(graded.execution.explanation);
    set_text(data, "look", look_first_sentence(graded));
    if (has_answers(graded)) set_text(data, "missing", missing_sentence(graded));
    data["changes"] = changes_of(graded, mark);
    if (has_answers(graded)) {
        const Marking& own = own_marking(marking_, graded.submission);
        const auto asked = &own == &marking_ ? asked_ : expected_texts(own.key);
        std::string rows;
        for (const QuestionScore& question : graded.score.questions) rows += rows_of(graded, question, asked, printout);
        data["rows"] = rows;
        set_text(data, "picture", picture_of(graded, index));
    }
    const std::string student = label_of(graded.submission);
    const auto show = [&](const char* name, const Listing& listing, std::string_view label) {
        const std::string html = listing.html(label);
        listing_bytes_ += html.size();
        set_text(data, name, html);
    };
    show("printout", printout, "What " + student + " printed");
    show("source", source, "The source of " + student);
    if (is_printout_too_long(graded)) data["too_long"] = std::string(too_long_sentence);
    data["source_not_kept"] = source_text.empty() && !graded.submission.source_sha256.empty();
    data["kept_kib"] = std::to_string(longest_kept_printout >> 10U);
    const Evidence evidence{"h4", most_text_bytes, Audience::instructor};
    data["messages"] = evidence.compiler(graded, source);
    data["evidence"] = evidence.others(graded, printout, source);
    return sheet_.fill_in(data);
}

}  // namespace harness::report
