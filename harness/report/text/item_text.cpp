#include "harness/report/text/item_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "harness/execution/tier.h"
#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/variants_sentences.h"
#include "harness/report/compile_error/compiler_hints.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"
#include "harness/text/utf8.h"
#include "reference/key/key_formats.h"

namespace harness::report {
namespace {

std::string right_value(const ItemScore& item, const Marking& marking) {
    const reference::KeyItem* asked = reference::asked_item(marking.key, item.spec.id);
    return asked == nullptr ? "" : value_text(asked->answers.front().value, asked->spec.shape);
}

}  // namespace

bool is_passed(double points, double max_points, ItemVerdict verdict) {
    constexpr double rounding = 1e-9;  // rounding error of sums of shares
    if (max_points > 0) return points >= max_points - rounding;
    return verdict == ItemVerdict::right || verdict == ItemVerdict::follow;
}

std::string override_text(const Override* override_) {
    if (override_ == nullptr) return "";
    return fmt::format("Set by the instructor: {} points, {}\n", points_text(override_->points),
                       escape_control(override_->why));
}

std::string item_text(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      const Marking& marking, reference::Feedback most, std::string* said) {
    std::string text = fmt::format("{}: {}, {} of {} points{}\n", name_in_question(item.spec), word_of(item.verdict),
                                   points_text(final_points(graded, question, item)), points_text(item.max_points),
                                   item.line == 0 ? "" : fmt::format(" (line {} of the output)", item.line));
    const reference::Feedback feedback = std::min(feedback_now(marking.assignment.rubric), most);
    const std::string sentence = item_sentence(item, graded.execution.outcome, feedback),
                      name = told_diagnosis(item, feedback);
    const bool is_said =
        said != nullptr && item.verdict == ItemVerdict::follow && std::exchange(*said, sentence) == sentence;
    if (!sentence.empty()) {
        if (!item.printed.empty())
            text += fmt::format("  {} {}\n", capitalized(before_printed(item)), escape_control(item.printed));
        if (!is_said) text += "  " + sentence + (name.empty() ? "" : fmt::format(" ({})", name)) + "\n";
    }
    for (const std::string& note : {told_reread(graded, item), item.experiment})
        if (!note.empty()) text += "  " + escape_control(note) + "\n";
    const bool is_shown = feedback == reference::Feedback::expected && item.verdict != ItemVerdict::right;
    if (is_shown) text += "  Correct value: " + right_value(item, marking) + "\n";
    const std::string word = override_text(find_override(graded, question.number, std::string(item.spec.name)));
    return text + (word.empty() ? "" : "  " + word);
}

std::string scenes_text(const Graded& graded) {
    std::string text;
    if (graded.findings.variants) {
        for (const std::string& sentence : variants_sentences(*graded.findings.variants, Audience::student))
            text += escape_control(sentence) + "\n";
    }
    return text + override_text(find_override(graded, 0, std::string(variants_place)));
}

std::vector<TestText> test_texts(const Graded& graded, const Marking& marking, reference::Feedback most) {
    std::vector<TestText> tests;
    for (const QuestionScore& question : graded.score.questions) {
        const double points = final_points(graded, question);
        std::string text, said;
        for (const ItemScore& item : question.items) text += item_text(graded, question, item, marking, most, &said);
        tests.push_back({fmt::format("Question {}: {}", question.number, question.title), question.number, points,
                         question.max_points, is_passed(points, question.max_points, question.verdict),
                         text + override_text(find_override(graded, question.number, ""))});
    }
    if (graded.score.variants) {
        const double points = final_scenes_points(graded), max_points = graded.score.variants->max_points;
        tests.push_back({"Other scenes", last_question(graded.score) + 1, points, max_points,
                         is_passed(points, max_points, ItemVerdict::wrong), scenes_text(graded)});
    }
    return tests;
}

std::string mark_text(const Graded& graded) {
    std::string text = "Not graded.\n";
    if (const auto mark = final_mark(graded)) {
        text = fmt::format("{} of {} points\n", points_text(mark->points), points_text(graded.score.max_points));
        if (mark->late_deduction > 0)
            text += fmt::format("Handed in late: {} points were taken off.\n", points_text(mark->late_deduction));
    }
    for (const std::string& sentence : instructor_sentences(graded)) text += escape_control(sentence) + "\n";
    return text;
}

std::string run_text(const Graded& graded) {
    std::string text;
    if (const std::string warning = sandbox_warning(graded.execution.tier); !warning.empty())
        text += "Warning: " + warning + "\n";
    if (!graded.execution.explanation.empty()) text += escape_control(graded.execution.explanation) + "\n";
    if (const std::string advice = crash_advice(graded); !advice.empty()) text += advice + "\n";
    for (const std::string& note : graded.submission.notes) text += escape_control(note) + "\n";
    for (const Flag& flag : flags_for_student(graded))
        text += title_of(flag.kind).sentence + ": " + escape_control(flag.evidence) + "\n";
    for (const std::string& finding : graded.execution.sanitizer)
        text += "Sanitizer: " + escape_control(finding) + "\n";
    return text + compiler_text(graded);
}

std::string submission_text(const Graded& graded) {
    return mark_text(graded) + run_text(graded);
}

std::string bounded(std::string text, std::size_t longest) {
    constexpr std::string_view rest = "\n… (cut here)\n";
    if (text.size() <= longest) return text;
    return fmt::format("{}{}", beginning_of_characters(text, longest - std::min(longest, rest.size())), rest);
}

}  // namespace harness::report
