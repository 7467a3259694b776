#include "harness/report/text/feedback.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "harness/execution/tier.h"
#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/hard_scenes_sentences.h"
#include "harness/record/override_place.h"
#include "harness/record/variants_sentences.h"
#include "harness/report/compile_error/compiler_hints.h"
#include "harness/report/compile_error/compiler_messages.h"
#include "harness/report/text/look_first.h"
#include "harness/report/text/sentences.h"
#include "harness/text/escape.h"
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

/// Text from the submission within a line, as a code span that no backtick in the text can end.
std::string code(const std::string& text) {
    std::string safe = escape_control(text);
    std::replace(safe.begin(), safe.end(), '\n', ' ');
    const std::string fence(longest_run_of_backticks(safe) + 1, '`');
    const std::string_view pad = safe.starts_with('`') || safe.ends_with('`') ? " " : "";
    return fmt::format("{0}{1}{2}{1}{0}", fence, pad, safe);
}

std::string code_block(const std::string& text) {
    const std::string safe = escape_control(text);
    const std::string fence(std::max<std::size_t>(3, longest_run_of_backticks(safe) + 1), '`');
    return fmt::format("{0}\n{1}{2}{0}\n", fence, safe, safe.ends_with('\n') ? "" : "\n");
}

/// Untrusted text within a line: escapes the characters that Markdown or HTML would interpret.
std::string plain(const std::string& text) {
    std::string safe;
    for (const char c : escape_control(text)) {
        if (std::string_view("\\`*[]<>&|").find(c) != std::string_view::npos) safe += '\\';
        safe += c == '\n' ? ' ' : c;
    }
    return safe;
}

/// The student by name; a submission of an unknown student by its id.
std::string whose(const Submission& submission) {
    const std::string label = label_of(submission);
    return label == submission.id ? "Submission " + code(label) : plain(label);
}

std::string where(const ItemScore& item) {
    return item.line == 0 ? "" : fmt::format(" (line {} of your output)", item.line);
}

std::string item_line(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      reference::Feedback feedback) {
    const std::string name =
        item.spec.shape == reference::Shape::first_object ? "the verdict" : std::string(item.spec.name);
    const std::string part = item.spec.part == 0 ? "" : fmt::format(" {})", item.spec.part);
    std::string text = fmt::format("- Question {}{}, {}{}: ", question.number, part, name, where(item));
    if (!item.printed.empty()) text += fmt::format("{} {}. ", before_printed(item), code(item.printed));
    text += plain(item_sentence(item, graded.execution.outcome, feedback));
    if (const std::string mistake = told_diagnosis(item, feedback); !mistake.empty())
        text += fmt::format(" ({})", plain(mistake));
    text += fmt::format(" {} of {} points", points_text(item.points), points_text(item.max_points));
    const Override* given = find_override(graded, question.number, std::string(item.spec.name));
    if (given != nullptr) text += fmt::format("; your instructor gave {}", points_text(given->points));
    return text + ".\n";
}

/// What the instructor gave instead, and why.
std::string from_the_instructor(const Graded& graded) {
    std::string text;
    for (const Override& given : graded.review.overrides) {
        const auto there = points_at(graded.score, given);
        if (!there || find_override(graded, given.question, given.item) != &given) continue;
        const std::string instead = graded.execution.outcome == Outcome::not_graded
                                        ? ""
                                        : fmt::format(", in place of {}", points_text(there->automatic));
        text += fmt::format("- Your instructor gave {} of {} for {}{}: {}\n", points_text(given.points),
                            points_text(there->most), place_in_words(given), instead, code(given.why));
    }
    for (const std::string& sentence : reread_sentences(graded.score)) text += fmt::format("- {}\n", plain(sentence));
    for (const Comment& comment : comments_on(graded))
        text += fmt::format("- {}: {}\n", comment.head, code(comment.text));
    return text.empty() ? "" : text + "\n";
}

/// The mark and, if it is not the sum of the questions, why.
std::string mark_lines(const Graded& graded) {
    const auto mark = final_mark(graded);
    if (!mark) return from_the_instructor(graded);
    std::string text =
        fmt::format("**{} of {} points**\n\n", points_text(mark->points), points_text(graded.score.max_points));
    if (mark->late_deduction > 0) {
        text += fmt::format("Handed in late: {} of {} points are taken off ({:g} %).\n\n",
                            points_text(mark->late_deduction), points_text(mark->points + mark->late_deduction),
                            graded.late_share * 100);
    }
    return text + from_the_instructor(graded);
}

std::string verdict_of(const QuestionScore& question) {
    const bool all_unreadable = std::all_of(question.items.begin(), question.items.end(),
                                            [](const ItemScore& i) { return i.verdict == ItemVerdict::unreadable; });
    return all_unreadable ? "unreadable" : std::string(to_string(question.verdict));
}

std::string items_worth_saying(const Graded& graded, reference::Feedback feedback) {
    std::string text;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict != ItemVerdict::right && item.verdict != ItemVerdict::missing)
                text += item_line(graded, question, item, feedback);
        }
    }
    for (const std::string& sentence : {missing_sentence(graded), accepted_sentence(graded.score)})
        if (!sentence.empty()) text += fmt::format("- {}\n", plain(sentence));
    return text;
}

std::string list_of(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += fmt::format("- {}\n", plain(sentence));
    return text;
}

/// What the other scenes showed; empty when none was tried.
std::vector<std::string> variants_of(const Graded& graded) {
    return graded.findings.variants ? variants_sentences(*graded.findings.variants) : std::vector<std::string>();
}

/// What the hard scenes showed; empty when none was tried.
std::vector<std::string> hard_scenes_of(const Graded& graded) {
    return graded.findings.hard_scenes ? hard_scenes_sentences(*graded.findings.hard_scenes)
                                       : std::vector<std::string>();
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
    std::string text = fmt::format("# {}\n\n{}\n\n", plain(marking.assignment.title), whose(graded.submission));
    if (const std::string warning = sandbox_warning(graded.execution.tier); !warning.empty()) {
        text += fmt::format("> **Warning.** {}\n\n", warning);
    }
    if (graded.execution.outcome == Outcome::not_graded) {
        const std::string reason = reason_for_student(graded.submission);
        return text + mark_lines(graded) +
               fmt::format("**Not graded.** {}\n", graded.submission.problem ? code(reason) : reason);
    }
    const Score& score = graded.score;
    text += mark_lines(graded);
    if (!graded.execution.explanation.empty()) text += plain(graded.execution.explanation) + "\n\n";
    if (const std::string advice = crash_advice(graded); !advice.empty()) text += code_block(advice) + "\n";
    if (const std::string look = look_first_sentence(graded); !look.empty()) text += fmt::format("**{}**\n\n", look);
    if (score.follow_cap) text += cap_sentence(*score.follow_cap) + "\n\n";
    text += "| Question | | Result | Points |\n|---:|---|---|---:|\n";
    for (const QuestionScore& question : score.questions) {
        text +=
            fmt::format("| {} | {} | {} | {} of {} |\n", question.number, plain(question.title), verdict_of(question),
                        points_text(final_points(graded, question)), points_text(question.max_points));
    }
    if (score.variants) {
        text += fmt::format("| | other scenes | | {} of {} |\n", points_text(final_scenes_points(graded)),
                            points_text(score.variants->max_points));
    }
    const bool has_follow = std::any_of(score.questions.begin(), score.questions.end(),
                                        [](const QuestionScore& q) { return q.verdict == ItemVerdict::follow; });
    if (has_follow) text += "\n`follow`: wrong, but computed correctly from your own earlier answers.\n";
    const std::string items = graded.execution.outcome == Outcome::compile_error
                                  ? ""
                                  : items_worth_saying(graded, feedback_now(marking.assignment.rubric));
    if (!items.empty()) text += "\n## Answers to look at\n\n" + items;
    if (const std::vector<Flag> open = flags_for_student(graded); !open.empty()) {
        text += "\n## To look at\n\n";
        for (const Flag& flag : open) {
            text += fmt::format("- {}: {}\n", plain(title_of(flag.kind).sentence), code(flag.evidence));
        }
    }
    if (const std::string variants = list_of(variants_of(graded)); !variants.empty())
        text += fmt::format("\n## On other scenes\n\n{}\n\n{}",
                            score.variants ? scenes_sentence(graded) : "This costs no points.", variants);
    if (const std::string hard_scenes = list_of(hard_scenes_of(graded)); !hard_scenes.empty())
        text += "\n## On hard scenes\n\nThis costs no points.\n\n" + hard_scenes;
    if (!graded.execution.sanitizer.empty()) {
        text += "\n## What the sanitizers found\n\nThis costs no points, but the program may do anything there.\n\n";
        for (const std::string& finding : graded.execution.sanitizer) text += "- " + code(finding) + "\n";
    }
    if (!graded.submission.notes.empty()) {
        text += "\n## Notes\n\n";
        for (const std::string& note : graded.submission.notes) text += "- " + code(note) + "\n";
    }
    if (const std::string hints = list_of(compiler_hints(graded)); !hints.empty())
        text += "\n## What to try\n\n" + hints;
    if (!graded.execution.build.diagnostics.empty()) {
        const bool failed = graded.execution.outcome == Outcome::compile_error;
        text += fmt::format("\n## The compiler's messages\n\n{}{}", failed ? "" : "Warnings cost no points.\n\n",
                            code_block(first_messages(graded.execution.build.diagnostics)));
    }
    if (!graded.execution.run.errors.empty())
        text += "\n## What the program wrote to standard error\n\n" + code_block(graded.execution.run.errors);
    return text;
}

std::string check_text(const Graded& graded, reference::Feedback feedback, Colors colors) {
    std::string text;
    if (const std::string warning = sandbox_warning(graded.execution.tier); !warning.empty())
        text += "Warning: " + warning + "\n";
    if (!graded.execution.explanation.empty()) text += escape_control(graded.execution.explanation) + "\n";
    if (const std::string advice = crash_advice(graded); !advice.empty()) text += advice + "\n";
    for (const std::string& note : graded.submission.notes) text += escape_control(note) + "\n";
    text += compiler_text(graded);
    for (const Flag& flag : flags_for_student(graded))
        text += title_of(flag.kind).sentence + ": " + escape_control(flag.evidence) + "\n";
    for (const std::string& sentence : variants_of(graded)) text += escape_control(sentence) + "\n";
    for (const std::string& finding : graded.execution.sanitizer)
        text += "Found by the sanitizers: " + escape_control(finding) + "\n";
    if (graded.execution.outcome == Outcome::not_graded) return text;
    const std::string points =
        fmt::format("\n{} of {} points\n", points_text(graded.score.points), points_text(graded.score.max_points));
    if (graded.execution.outcome == Outcome::compile_error) return text + points;
    for (const QuestionScore& question : graded.score.questions) {
        text += fmt::format("Question {}, {}: {} of {} points\n", question.number, question.title,
                            points_text(question.points), points_text(question.max_points));
        for (const ItemScore& item : question.items) {
            const std::string verdict = fmt::format("{:<10}", to_string(item.verdict));
            text += fmt::format("  {:<13} {}{}\n", name_in_question(item.spec),
                                colored(verdict, color_of(item.verdict), colors), where(item));
            if (item.verdict == ItemVerdict::right || item.verdict == ItemVerdict::missing) continue;
            if (!item.printed.empty())
                text += fmt::format("      {} {}\n", before_printed(item), escape_control(item.printed));
            const std::string name = told_diagnosis(item, feedback);
            text += fmt::format("      {}{}\n", item_sentence(item, graded.execution.outcome, feedback),
                                name.empty() ? "" : fmt::format(" ({})", name));
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
