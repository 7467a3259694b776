#include "harness/report/page/student_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/execution/tier.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/page/evidence.h"
#include "harness/report/page/listing.h"
#include "harness/report/page/page_template.h"
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

/// Whether all its answers are missing, so that one sentence for all such questions is enough.
bool is_missing(const QuestionScore& question) {
    return all_have(question, ItemVerdict::missing);
}

/// Whether the page has more to say about the question than that it is right or missing.
bool is_worth_a_section(const Graded& graded, const QuestionScore& question) {
    return !is_without_answers(graded) && !all_have(question, ItemVerdict::right) && !is_missing(question);
}

/// Whether the instructor gave points to the question as a whole.
bool is_set(const Graded& graded, const QuestionScore& question) {
    return find_override(graded, question.number, "") != nullptr;
}

/// "Rossi, Giulia, ray_cast.cpp": the file as the student named it.
std::string who_of(const Submission& submission) {
    const bool is_renamed = submission.lms && !submission.lms->file.empty();
    const std::string file = is_renamed ? submission.lms->file : submission.file.filename().string();
    return label_of(submission) + (file.empty() ? "" : ", " + file);
}

/// The reasons why the points differ from the automatic sum.
PageData list_of_changes(const Graded& graded, const std::optional<FinalMark>& mark) {
    PageData list(PageData::type::list);
    const auto add = [&](const std::string& text) {
        PageData change;
        change["text"] = text;
        list.push_back(change);
    };
    if (graded.score.variants && has_marks(graded)) add(scenes_sentence(graded));
    if (graded.score.follow_cap && has_marks(graded)) add(cap_sentence(*graded.score.follow_cap));
    for (const std::string& sentence : instructor_sentences(graded)) add(sentence);
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

/// A sentence about a question that is only consistent with earlier ones.
std::string note_of(const QuestionScore& question, const std::optional<LookFirst>& look) {
    const bool follows =
        look && std::find(look->following.begin(), look->following.end(), question.number) != look->following.end();
    if (!follows) return "";
    const std::string fix =
        !look->is_only || look->is_missing ? "the earlier answers" : fmt::format("question {}", look->question);
    return fmt::format("This step is correct for the values you had; fix {} and this one will be right too.", fix);
}

/// Makes the page of one submission.
class StudentPage {
  public:
    StudentPage(const Graded& graded, const Marking& marking)
        : graded_(graded),
          marking_(marking),
          feedback_(feedback_now(marking.assignment.rubric)),
          asked_(feedback_ == reference::Feedback::expected ? expected_texts(marking.key) : ExpectedTexts()),
          look_(look_first(graded)),
          printout_(Listing::of_printout(shown_printout(graded), notes_of_answers(graded.score), "o")) {}

    std::string html() const;

  private:
    std::string question(const QuestionScore& question) const;
    /// `said`: the note on the question already says why the item is not right.
    PageData item(const QuestionScore& question, const ItemScore& item, bool said) const;

    const Graded& graded_;
    const Marking& marking_;
    reference::Feedback feedback_;
    ExpectedTexts asked_;  ///< expected values; empty if the rubric does not show them
    std::optional<LookFirst> look_;
    Listing printout_;
};

PageData StudentPage::item(const QuestionScore& question, const ItemScore& item, bool said) const {
    PageData data;
    data["name"] = name_in_question(item.spec);
    data["item_class"] = std::string(to_string(item.verdict));
    data["item_word"] = std::string(word_of(item.verdict));
    const bool item_set = find_override(graded_, question.number, std::string(item.spec.name)) != nullptr;
    data["has_points"] = !is_set(graded_, question);
    data["item_got"] = points_text(final_points(graded_, question, item));
    data["item_most"] = points_text(item.max_points);
    if (item_set) data["item_automatic"] = points_text(item.points);
    set_text(data, "printed", item.printed);
    data["before_printed"] = capitalized(before_printed(item));
    if (item.line != 0) data["line"] = printout_.with_links(fmt::format("line {}", item.line));
    const auto asked = asked_.find(item.spec.id);
    if (asked != asked_.end() && item.verdict != ItemVerdict::right) data["asked"] = asked->second.beside(item);
    if (!said) set_text(data, "sentence", item_sentence(item, graded_.execution.outcome, feedback_));
    set_text(data, "diagnosis", told_diagnosis(item, feedback_));
    return data;
}

std::string StudentPage::question(const QuestionScore& question) const {
    PageData data = cell_of(graded_, question);
    data["is_first"] = look_ && look_->own_scene.empty() && (look_->is_missing || !look_->ended_early) &&
                       look_->question == question.number;
    const std::string note = note_of(question, look_);
    set_text(data, "note", note);
    PageData items(PageData::type::list), found(PageData::type::list);
    std::string right, missing, said;
    for (const ItemScore& scored : question.items) {
        if (!scored.experiment.empty()) found.push_back(printout_.with_links(scored.experiment));
        if (scored.verdict == ItemVerdict::right) {
            right += (right.empty() ? "" : ", ") + name_in_question(scored.spec);
        } else if (scored.verdict == ItemVerdict::missing) {
            missing += (missing.empty() ? "" : ", ") + name_in_question(scored.spec);
        } else {
            const bool follows = scored.verdict == ItemVerdict::follow;
            const std::string sentence = item_sentence(scored, graded_.execution.outcome, feedback_);
            const bool is_said = follows && ((!note.empty() && scored.advice.empty()) || sentence == said);
            if (follows) said = sentence;
            items.push_back(item(question, scored, is_said));
        }
    }
    set_text(data, "right", right);
    set_text(data, "missing", missing);
    data["has_items"] = items.is_non_empty_list();
    data["items"] = std::move(items);
    data["found"] = std::move(found);
    return PageTemplate(templates::question_mustache).fill_in(data);
}

std::string StudentPage::html() const {
    PageData data;
    const std::string style(templates::page_css);
    data["policy"] = security_policy({style});
    data["style"] = style;
    data["title"] = marking_.assignment.title;
    data["id"] = label_of(graded_.submission);
    data["who"] = who_of(graded_.submission);
    const std::optional<FinalMark> mark = final_mark(graded_);
    if (mark) data["points"] = points_text(mark->points);
    data["max"] = points_text(graded_.score.max_points);
    set_text(data, "warning", sandbox_warning(graded_.execution.tier));
    const bool ungraded = graded_.execution.outcome == Outcome::not_graded;
    if (ungraded) data["not_graded"] = reason_for_student(graded_.submission);
    if (!ungraded && !graded_.execution.explanation.empty())
        data["explanation"] = printout_.with_links(graded_.execution.explanation);
    set_text(data, "crash_advice", crash_advice(graded_));
    if (look_) {
        PageData first;
        first["number"] = std::to_string(look_->question);
        first["invitation"] = invitation(*look_);
        first["reason"] = reason(*look_);
        data["first"] = std::move(first);
    } else if (graded_.execution.outcome == Outcome::graded && graded_.score.points == graded_.score.max_points) {
        data["all_right"] = "Every answer is right.";
    }
    data["changes"] = list_of_changes(graded_, mark);
    data["compile_error"] = graded_.execution.outcome == Outcome::compile_error;
    data["has_questions"] = has_marks(graded_);
    PageData cells(PageData::type::list);
    std::string sections;
    if (has_marks(graded_)) {
        for (const QuestionScore& each : graded_.score.questions) {
            cells.push_back(cell_of(graded_, each));
            if (is_worth_a_section(graded_, each)) sections += question(each);
        }
        // If nothing is wrong, a picture would waste time and space.
        const bool with_answers = feedback_ == reference::Feedback::expected;
        if (!sections.empty()) data["picture"] = explaining_picture(marking_, &graded_, with_answers, "scene-");
    }
    data["questions"] = std::move(cells);
    data["sections"] = sections;
    if (has_marks(graded_) && !is_without_answers(graded_)) set_text(data, "missing", missing_sentence(graded_));
    if (has_marks(graded_)) set_text(data, "accepted", accepted_sentence(graded_.score));
    if (!printout_.empty()) data["printout"] = printout_.html("Your program's output");
    if (is_printout_too_long(graded_)) data["too_long"] = std::string(too_long_sentence);
    const Evidence evidence{"h2", most_bytes, Audience::student};
    data["messages"] = evidence.compiler(graded_, Listing());
    data["evidence"] = evidence.others(graded_, printout_, Listing());
    return std::string(page_beginning) + PageTemplate(templates::student_mustache).fill_in(data);
}

}  // namespace

std::string student_page(const Graded& graded, const Marking& marking) {
    return StudentPage(graded, marking).html();
}

}  // namespace harness::report
