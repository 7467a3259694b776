#include <fmt/format.h>

#include <algorithm>

#include "harness/clean_text.h"
#include "harness/report/report.h"
#include "harness/variants/variant_sentences.h"

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

/// Text from the submission within a line: a code span that no backtick in it can end.
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

std::string cap_sentence(double cap) {
    return fmt::format("Answers that follow from an earlier mistake earn at most {} points in all.", points_text(cap));
}

std::string where(const ItemScore& item) {
    return item.line == 0 ? "" : fmt::format(" (line {} of your output)", item.line);
}

std::string item_line(int question, const ItemScore& item, Outcome outcome) {
    const std::string name = item.spec.shape == reference::Shape::verdict ? "the verdict" : std::string(item.spec.name);
    std::string text = fmt::format("- Question {}, {}{}: ", question, name, where(item));
    if (!item.printed.empty()) text += fmt::format("you printed {}. ", code(item.printed));
    text += item_sentence(item, outcome);
    if (!item.diagnosis.empty()) text += fmt::format(" ({})", item.diagnosis);
    return text + fmt::format(" {} of {} points.\n", points_text(item.points), points_text(item.max_points));
}

std::string verdict_of(const QuestionScore& question) {
    const bool all_unreadable = std::all_of(question.items.begin(), question.items.end(),
                                            [](const ItemScore& i) { return i.verdict == ItemVerdict::unreadable; });
    return all_unreadable ? "unreadable" : std::string(to_string(question.verdict));
}

std::string items_worth_saying(const Graded& graded) {
    std::string text;
    for (const QuestionScore& question : graded.score.questions) {
        const bool all_missing = std::all_of(question.items.begin(), question.items.end(),
                                             [](const ItemScore& i) { return i.verdict == ItemVerdict::missing; });
        if (all_missing && question.items.size() > 1) {
            text += fmt::format("- Question {}: no answer was found in the output. 0 of {} points.\n", question.number,
                                points_text(question.max_points));
            continue;
        }
        for (const ItemScore& item : question.items) {
            if (!item_sentence(item, graded.outcome).empty()) text += item_line(question.number, item, graded.outcome);
        }
    }
    return text;
}

/// For the student, whom neither the machine's troubles nor its folders concern; the instructor has both in the table.
std::string why_not_graded(const Submission& submission) {
    if (!submission.problem) return "That is not the program's fault: something went wrong here. Ask your instructor.";
    std::string problem = *submission.problem;
    const std::string folder = submission.file.parent_path().string() + "/";
    for (std::size_t at = problem.find(folder); folder != "/" && at != std::string::npos; at = problem.find(folder)) {
        problem.erase(at, folder.size());
    }
    return code(problem);
}

/// What a flag says, for a person.
std::string flag_title(const Flag& flag) {
    if (flag.kind == "nondeterministic") return "The program does not answer the same each time";
    if (flag.kind == "hard_coded") return "The printed numbers do not change when the scene in the source does";
    return flag.kind;
}

/// What the other scenes showed, a line each behind `bullet`; empty when none was tried.
std::string other_scenes_text(const Graded& graded, std::string_view bullet) {
    std::string text;
    if (!graded.other_scenes) return text;
    for (const std::string& sentence : variants::variant_sentences(*graded.other_scenes))
        text += fmt::format("{}{}\n", bullet, escape_control(sentence));
    return text;
}

}  // namespace

std::string feedback_markdown(const Graded& graded, const Marking& marking) {
    std::string text = fmt::format("# {}\n\nSubmission {}\n\n", marking.assignment.title, code(graded.submission.id));
    if (const std::string warning = sandbox_warning(graded.tier); !warning.empty()) {
        text += fmt::format("> **Warning.** {}\n\n", warning);
    }
    if (graded.outcome == Outcome::not_graded) {
        return text + fmt::format("**Not graded.** {}\n", why_not_graded(graded.submission));
    }
    const Score& score = graded.score;
    text += fmt::format("**{} of {} points**\n\n", points_text(score.points), points_text(score.max_points));
    if (!graded.explanation.empty()) text += graded.explanation + "\n\n";
    if (score.follow_cap) text += cap_sentence(*score.follow_cap) + "\n\n";
    text += "| Question | | Result | Points |\n|---:|---|---|---:|\n";
    for (const QuestionScore& question : score.questions) {
        text +=
            fmt::format("| {} | {} | {} | {} of {} |\n", question.number, reference::question_title(question.number),
                        verdict_of(question), points_text(question.points), points_text(question.max_points));
    }
    const std::string items = graded.outcome == Outcome::compile_error ? "" : items_worth_saying(graded);
    if (!items.empty()) text += "\n## Answers to look at\n\n" + items;
    if (!graded.flags.empty()) {
        text += "\n## For a person to look at\n\n";
        for (const Flag& flag : graded.flags) text += fmt::format("- {}: {}\n", flag_title(flag), code(flag.evidence));
    }
    if (const std::string other_scenes = other_scenes_text(graded, "- "); !other_scenes.empty())
        text += "\n## On other scenes\n\nThis costs no points.\n\n" + other_scenes;
    if (!graded.sanitizer.empty()) {
        text += "\n## What the sanitizers found\n\nThis costs no points, but the program may do anything there.\n\n";
        for (const std::string& finding : graded.sanitizer) text += "- " + code(finding) + "\n";
    }
    if (!graded.submission.notes.empty()) {
        text += "\n## Notes\n\n";
        for (const std::string& note : graded.submission.notes) text += "- " + code(note) + "\n";
    }
    if (!graded.build.diagnostics.empty()) {
        const bool failed = graded.outcome == Outcome::compile_error;
        text += fmt::format("\n## The compiler's messages\n\n{}{}", failed ? "" : "Warnings cost no points.\n\n",
                            code_block(graded.build.diagnostics));
    }
    if (!graded.run.errors.empty())
        text += "\n## What the program wrote to standard error\n\n" + code_block(graded.run.errors);
    return text;
}

std::string check_text(const Graded& graded) {
    std::string text;
    if (const std::string warning = sandbox_warning(graded.tier); !warning.empty())
        text += "Warning: " + warning + "\n";
    if (!graded.explanation.empty()) text += escape_control(graded.explanation) + "\n";
    for (const std::string& note : graded.submission.notes) text += escape_control(note) + "\n";
    if (!graded.build.diagnostics.empty())
        text += "\nThe compiler's messages:\n" + escape_control(graded.build.diagnostics) + "\n";
    for (const Flag& flag : graded.flags) text += flag_title(flag) + ": " + escape_control(flag.evidence) + "\n";
    text += other_scenes_text(graded, "");
    for (const std::string& finding : graded.sanitizer)
        text += "Found by the sanitizers: " + escape_control(finding) + "\n";
    if (graded.outcome == Outcome::compile_error || graded.outcome == Outcome::not_graded) return text;
    for (const QuestionScore& question : graded.score.questions) {
        text += fmt::format("Question {}, {}: {} of {} points\n", question.number,
                            reference::question_title(question.number), points_text(question.points),
                            points_text(question.max_points));
        for (const ItemScore& item : question.items) {
            text += fmt::format("  {:<13} {:<10}{}\n", item.spec.name, to_string(item.verdict), where(item));
            const std::string sentence = item_sentence(item, graded.outcome);
            if (sentence.empty()) continue;
            if (!item.printed.empty()) text += fmt::format("      you printed {}\n", escape_control(item.printed));
            text += fmt::format("      {}{}\n", sentence,
                                item.diagnosis.empty() ? "" : fmt::format(" ({})", item.diagnosis));
        }
    }
    if (graded.score.follow_cap) text += "\n" + cap_sentence(*graded.score.follow_cap) + "\n";
    return text +
           fmt::format("\n{} of {} points\n", points_text(graded.score.points), points_text(graded.score.max_points));
}

}  // namespace harness::report
