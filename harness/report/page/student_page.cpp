#include "harness/report/page/student_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/execution/tier.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/page/templates.h"
#include "harness/report/picture/picture.h"
#include "harness/report/text/expected_text.h"
#include "harness/report/text/look_first.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

/// Limit for the compiler's messages and for each other text; grades.json has all of it.
constexpr std::size_t most_bytes = 64 << 10U;

bool has_marks(const Graded& graded) {
    return graded.execution.outcome != Outcome::not_graded && graded.execution.outcome != Outcome::compile_error;
}

bool all_have(const QuestionScore& question, ItemVerdict verdict) {
    return std::all_of(question.items.begin(), question.items.end(),
                       [&](const ItemScore& item) { return item.verdict == verdict; });
}

/// Whether all its answers are missing, so that one sentence on all such questions serves.
bool is_missing(const QuestionScore& question) {
    return all_have(question, ItemVerdict::missing);
}

/// Whether there is more to say than that the question is right or missing.
bool is_worth_a_section(const Graded& graded, const QuestionScore& question) {
    return !is_without_answers(graded) && !all_have(question, ItemVerdict::right) && !is_missing(question);
}

/// Whether the instructor gave the points of the question as a whole.
bool is_set(const Graded& graded, const QuestionScore& question) {
    return find_override(graded, question.number, "") != nullptr;
}

/// "Rossi, Giulia, ray_cast.cpp": the file as the student named it.
std::string who_of(const Submission& submission) {
    const bool is_renamed = submission.lms && !submission.lms->file.empty();
    const std::string file = is_renamed ? submission.lms->file : submission.file.filename().string();
    return label_of(submission) + (file.empty() ? "" : ", " + file);
}

/// Why the points differ from the sum of the automatic ones.
PageData list_of_changes(const Graded& graded, const std::optional<FinalMark>& mark) {
    PageData list(PageData::type::list);
    const auto add = [&](const std::string& text) {
        PageData change;
        change["text"] = text;
        list.push_back(change);
    };
    if (graded.score.variants && has_marks(graded)) add(scenes_sentence(graded));
    if (graded.score.follow_cap && has_marks(graded)) add(cap_sentence(*graded.score.follow_cap));
    for (const std::string& sentence : override_sentences(graded)) add(sentence);
    for (const std::string& sentence : reread_sentences(graded.score)) add(sentence);
    for (const Comment& comment : comments_on(graded)) add(comment.head + ": " + comment.text);
    if (mark && mark->late_deduction > 0)
        add(fmt::format("Handed in late: {} points are taken off.", points_text(mark->late_deduction)));
    return list;
}

/// A question in the strip at the top.
PageData cell_of(const Graded& graded, const QuestionScore& question) {
    PageData cell;
    const bool set = is_set(graded, question);
    cell["class"] = set ? "set" : std::string(class_of(question));
    cell["number"] = std::to_string(question.number);
    cell["question_title"] = question.title;
    cell["symbol"] = set ? "✎" : std::string(symbol_of(question));
    cell["word"] = set ? "points set by your instructor" : word_of(question);
    if (set) cell["automatic"] = points_text(question.points);
    cell["got"] = points_text(final_points(graded, question));
    cell["most"] = points_text(question.max_points);
    const bool has_section = is_worth_a_section(graded, question);
    cell["linked"] = has_section || (is_missing(question) && !is_without_answers(graded));
    cell["target"] = has_section ? fmt::format("q{}", question.number) : "missing";
    return cell;
}

/// What is said once of a question that only follows from earlier ones.
std::string note_of(const QuestionScore& question, const std::optional<LookFirst>& look) {
    const bool follows =
        look && std::find(look->following.begin(), look->following.end(), question.number) != look->following.end();
    if (!follows) return "";
    const std::string fix =
        !look->is_only || look->is_missing ? "the earlier answers" : fmt::format("question {}", look->question);
    return fmt::format("This step is correct for the values you had; fix {} and this one will be right too.", fix);
}

}  // namespace

StudentPages::StudentPages(const Marking& marking)
    : marking_(marking),
      feedback_(feedback_now(marking.assignment.rubric)),
      asked_(feedback_ == reference::Feedback::expected ? expected_texts(marking.key) : ExpectedTexts()),
      style_(templates::page_css),
      policy_(security_policy({style_})),
      page_(templates::student_mustache),
      question_(templates::question_mustache),
      evidence_("h2", most_bytes, Audience::student) {}

PageData StudentPages::item(const Graded& graded, const QuestionScore& question, const ItemScore& item, bool said,
                            const Listing& printout) const {
    PageData data;
    data["name"] = name_in_question(item.spec);
    data["item_class"] = std::string(to_string(item.verdict));
    data["item_word"] = std::string(word_of(item.verdict));
    const bool item_set = find_override(graded, question.number, std::string(item.spec.name)) != nullptr;
    data["has_points"] = !is_set(graded, question);
    data["item_got"] = points_text(final_points(graded, question, item));
    data["item_most"] = points_text(item.max_points);
    if (item_set) data["item_automatic"] = points_text(item.points);
    set_text(data, "printed", item.printed);
    data["before_printed"] = capitalized(before_printed(item));
    if (item.line != 0) data["line"] = printout.with_links(fmt::format("line {}", item.line));
    const auto asked = asked_.find(item.spec.id);
    if (asked != asked_.end() && item.verdict != ItemVerdict::right) data["asked"] = asked->second.beside(item);
    if (!said) set_text(data, "sentence", item_sentence(item, graded.execution.outcome, feedback_));
    set_text(data, "diagnosis", told_diagnosis(item, feedback_));
    return data;
}

std::string StudentPages::question(const Graded& graded, const QuestionScore& question, const Listing& printout) {
    const std::optional<LookFirst> look = look_first(graded);
    PageData data = cell_of(graded, question);
    data["is_first"] = look && !look->ended_early && look->question == question.number;
    const std::string note = note_of(question, look);
    set_text(data, "note", note);
    PageData items(PageData::type::list);
    std::string right, missing;
    for (const ItemScore& each : question.items) {
        if (each.verdict == ItemVerdict::right) {
            right += (right.empty() ? "" : ", ") + name_in_question(each.spec);
        } else if (each.verdict == ItemVerdict::missing) {
            missing += (missing.empty() ? "" : ", ") + name_in_question(each.spec);
        } else {
            items.push_back(item(graded, question, each,
                                 !note.empty() && each.verdict == ItemVerdict::follow && each.advice.empty(),
                                 printout));
        }
    }
    set_text(data, "right", right);
    set_text(data, "missing", missing);
    data["has_items"] = items.is_non_empty_list();
    data["items"] = std::move(items);
    return question_.fill_in(data);
}

std::string StudentPages::page(const Graded& graded) {
    PageData data;
    data["policy"] = policy_;
    data["style"] = style_;
    data["title"] = marking_.assignment.title;
    data["id"] = label_of(graded.submission);
    data["who"] = who_of(graded.submission);
    const std::optional<FinalMark> mark = final_mark(graded);
    if (mark) data["points"] = points_text(mark->points);
    data["max"] = points_text(graded.score.max_points);
    set_text(data, "warning", sandbox_warning(graded.execution.tier));
    const bool ungraded = graded.execution.outcome == Outcome::not_graded;
    if (ungraded) data["not_graded"] = reason_for_student(graded.submission);
    const Listing printout = Listing::of_printout(graded.execution.printout, notes_of_answers(graded.score), "o");
    if (!ungraded && !graded.execution.explanation.empty())
        data["explanation"] = printout.with_links(graded.execution.explanation);
    set_text(data, "crash_advice", crash_advice(graded));
    if (const std::optional<LookFirst> look = look_first(graded)) {
        PageData first;
        first["number"] = std::to_string(look->question);
        first["invitation"] = invitation(*look);
        first["reason"] = reason(*look);
        data["first"] = std::move(first);
    } else if (graded.execution.outcome == Outcome::graded && graded.score.points == graded.score.max_points) {
        data["all_right"] = "Every answer is right.";
    }
    data["changes"] = list_of_changes(graded, mark);
    data["compile_error"] = graded.execution.outcome == Outcome::compile_error;
    data["has_questions"] = has_marks(graded);
    PageData cells(PageData::type::list);
    std::string sections;
    if (has_marks(graded)) {
        for (const QuestionScore& each : graded.score.questions) {
            cells.push_back(cell_of(graded, each));
            if (is_worth_a_section(graded, each)) sections += question(graded, each, printout);
        }
        // If there is nothing to look at, a picture would waste time and bytes.
        const bool with_answers = feedback_ == reference::Feedback::expected;
        if (!sections.empty()) data["picture"] = explaining_picture(marking_, &graded, with_answers, "scene-");
    }
    data["questions"] = std::move(cells);
    data["sections"] = sections;
    if (has_marks(graded) && !is_without_answers(graded)) set_text(data, "missing", missing_sentence(graded));
    if (has_marks(graded)) set_text(data, "accepted", accepted_sentence(graded.score));
    if (!printout.empty()) data["printout"] = printout.html("What your program printed");
    data["printout_too_long"] = is_printout_too_long(graded);
    data["kept_kib"] = std::to_string(longest_kept_printout >> 10U);
    data["messages"] = evidence_.compiler(graded, Listing());
    data["evidence"] = evidence_.others(graded, printout, Listing());
    return std::string(page_beginning) + page_.fill_in(data);
}

std::string student_page(const Graded& graded, const Marking& marking) {
    return StudentPages(marking).page(graded);
}

}  // namespace harness::report
