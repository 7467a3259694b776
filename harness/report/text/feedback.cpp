#include "harness/report/text/feedback.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "harness/record/final_mark.h"
#include "harness/record/hard_scenes_sentences.h"
#include "harness/record/override_place.h"
#include "harness/report/text/item_text.h"
#include "harness/report/text/look_first.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/escape.h"
#include "harness/text/markup.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

std::size_t longest_run_of_backticks(std::string_view text) {
    std::size_t longest = 0;
    std::size_t run = 0;
    for (const char c : text) {
        run = c == '`' ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    return longest;
}

std::string code_block(const std::string& text) {
    const std::string safe = escape_control(text);
    const std::string fence(std::max<std::size_t>(3, longest_run_of_backticks(safe) + 1), '`');
    return fmt::format("{0}\n{1}{2}{0}\n", fence, safe, safe.ends_with('\n') ? "" : "\n");
}

std::string where(const ItemScore& item) {
    return item.line == 0 ? "" : fmt::format(" (line {} of your output)", item.line);
}

std::string feedback_text(const Graded& graded, const Marking& marking) {
    if (graded.execution.outcome == Outcome::not_graded)
        return mark_text(graded) + reason_for_student(graded.submission) + "\n";
    std::string text = submission_text(graded);
    for (const std::string& sentence : {look_first_sentence(graded), missing_sentence(graded)})
        if (!sentence.empty()) text += "\n" + sentence + "\n";
    if (graded.score.follow_cap) text += "\n" + cap_sentence(*graded.score.follow_cap) + "\n";
    if (graded.execution.outcome != Outcome::compile_error) {
        for (const TestText& test : test_texts(graded, marking, reference::Feedback::mistake))
            text += fmt::format("\n{}, {} of {} points\n{}", test.name, points_text(test.points),
                                points_text(test.max_points), test.text);
    }
    if (!graded.score.variants && graded.findings.variants)
        text += "\nOn other scenes, which cost no points:\n" + scenes_text(graded);
    if (graded.findings.hard_scenes) {
        text += "\nHard scenes, which cost no points:\n";
        for (const std::string& sentence : hard_scenes_sentences(*graded.findings.hard_scenes)) text += sentence + "\n";
    }
    if (!graded.execution.run.errors.empty()) text += "\nStandard error:\n" + graded.execution.run.errors;
    return text;
}

Color color_of(ItemVerdict verdict) {
    switch (verdict) {
        case ItemVerdict::right: return Color::green;
        case ItemVerdict::follow: return Color::cyan;
        case ItemVerdict::wrong: return Color::red;
        case ItemVerdict::missing:
        case ItemVerdict::unreadable: return Color::yellow;
    }
    return Color::yellow;
}

}  // namespace

std::string feedback_markdown(const Graded& graded, const Marking& marking) {
    return fmt::format("# {}\n\n{}\n\n{}", escape_markdown(marking.assignment.title),
                       escape_markdown(label_of(graded.submission)), code_block(feedback_text(graded, marking)));
}

std::string check_text(const Graded& graded, reference::Feedback feedback, Colors colors) {
    std::string text = run_text(graded);
    if (graded.findings.variants) text += "\n" + scenes_text(graded);
    if (graded.execution.outcome == Outcome::not_graded) return text;
    const std::string points =
        fmt::format("\n{} of {} points\n", points_text(graded.score.points), points_text(graded.score.max_points));
    if (graded.execution.outcome == Outcome::compile_error) return text + points;
    for (const QuestionScore& question : graded.score.questions) {
        text += fmt::format("Question {}, {}: {} of {} points\n", question.number, question.title,
                            points_text(question.points), points_text(question.max_points));
        std::string said;  // once a question
        for (const ItemScore& item : question.items) {
            const std::string verdict = fmt::format("{:<10}", word_of(item.verdict));
            text += fmt::format("  {:<13} {}{}\n", name_in_question(item.spec),
                                colored(verdict, color_of(item.verdict), colors), where(item));
            if (!item.experiment.empty()) text += "      " + item.experiment + "\n";
            if (item.verdict == ItemVerdict::right || item.verdict == ItemVerdict::missing) continue;
            if (!item.printed.empty())
                text += fmt::format("      {} {}\n", before_printed(item), escape_control(item.printed));
            const std::string name = told_diagnosis(item, feedback);
            const std::string sentence = item_sentence(item, graded.execution.outcome, feedback);
            if (item.verdict == ItemVerdict::follow && std::exchange(said, sentence) == sentence) continue;
            text += fmt::format("      {}{}\n", sentence, name.empty() ? "" : fmt::format(" ({})", name));
        }
    }
    for (const std::string& sentence :
         {missing_sentence(graded), accepted_sentence(graded.score), look_first_sentence(graded)}) {
        if (!sentence.empty()) text += "\n" + sentence + "\n";
    }
    if (graded.score.variants) text += "\n" + scenes_sentence(graded) + "\n";
    if (graded.score.follow_cap) text += "\n" + cap_sentence(*graded.score.follow_cap) + "\n";
    return text + points;
}

}  // namespace harness::report
