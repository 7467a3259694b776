#include "harness/report/text/class_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "harness/execution/tier.h"
#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/text/columns.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

/// "Rossi, Giulia (rossigiulia)": a command needs the id.
std::string called(const Submission& submission) {
    const std::string label = one_line(label_of(submission)), id = one_line(submission.id);
    return label == id ? id : fmt::format("{} ({})", label, id);
}

/// At most a terminal line; the report has the rest.
std::string shortened(const std::string& evidence) {
    constexpr std::size_t longest = 160;
    std::string line = one_line(evidence);
    if (code_points(line) <= longest) return line;
    line = padded(line, longest);
    return line.substr(0, line.find_last_of(' ')) + " …";
}

/// "hard coded, reading doubtful"
std::string flags_of(const Graded& graded) {
    std::vector<std::string> names;
    for (const Flag& flag : open_flags(graded)) {
        names.push_back(one_line(flag.kind));
        std::ranges::replace(names.back(), '_', ' ');
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// The name of each submission in the table: its student's name, or its id if several students have this name.
std::vector<std::string> names_in_table(const std::vector<Graded>& graded) {
    std::map<std::string, int> times;
    for (const Graded& result : graded) ++times[label_of(result.submission)];
    std::vector<std::string> names;
    for (const Graded& one : graded) {
        const std::string label = label_of(one.submission);
        names.push_back(one_line(times[label] == 1 ? label : one.submission.id));
    }
    return names;
}

std::string row_of(const Graded& graded, const std::string& name, std::size_t id_width, Colors colors) {
    const std::string outcome = fmt::format("{:<13}", outcome_words(graded.execution.outcome));
    std::string row = padded(name, id_width) + "  " +
                      (graded.execution.outcome == Outcome::graded ? outcome : colored(outcome, Color::red, colors));
    const bool marked = graded.execution.outcome != Outcome::not_graded;
    for (const QuestionScore& question : graded.score.questions)
        row += fmt::format(" {:>5}", marked ? points_text(final_points(graded, question)) : "-");
    const auto points = points_that_count(graded);
    row += fmt::format("  {:>6}{}", points ? points_text(*points) : "-", graded.review.overrides.empty() ? "" : "*");
    const std::string flags = flags_of(graded);
    if (!flags.empty()) row += (graded.review.overrides.empty() ? "   " : "  ") + colored(flags, Color::yellow, colors);
    return row + "\n";
}

/// The instructor's overrides and the late deductions.
std::string departures(const std::vector<Graded>& graded) {
    std::string text;
    for (const Graded& result : graded) {
        const std::string id = called(result.submission);
        for (const Override& given : result.review.overrides) {
            const auto automatic = points_at(result.score, given);
            if (!automatic) continue;
            const bool marked = result.execution.outcome != Outcome::not_graded;
            text += fmt::format("* {}: {} {} instead of {}, by {}: {}\n", id, place_of(given),
                                points_text(given.points), marked ? points_text(automatic->automatic) : "no mark",
                                one_line(given.by), one_line(given.why));
        }
        const auto mark = final_mark(result);
        if (mark && mark->late_deduction > 0) {
            text += fmt::format("late: {}: {} points taken off, {:g} %\n", id, points_text(mark->late_deduction),
                                result.late_share * 100);
        }
    }
    return text.empty() ? "" : "\n" + text;
}

struct Tally {
    std::string title;
    int right = 0, follow = 0, wrong = 0, missing = 0, unreadable = 0;
    double points = 0, max_points = 0;
};

void count(Tally& tally, const Graded& graded, const QuestionScore& question) {
    tally.title = question.title;
    tally.points += final_points(graded, question);
    tally.max_points += question.max_points;
    for (const ItemScore& item : question.items) {
        switch (item.verdict) {
            case ItemVerdict::right: ++tally.right; break;
            case ItemVerdict::follow: ++tally.follow; break;
            case ItemVerdict::wrong: ++tally.wrong; break;
            case ItemVerdict::missing: ++tally.missing; break;
            case ItemVerdict::unreadable: ++tally.unreadable; break;
        }
    }
}

/// A line like a question's; empty if the rubric gives no points for other scenes.
std::string scenes_summary(const std::vector<Graded>& graded) {
    double points = 0, most = 0;
    for (const Graded& result : graded) {
        if (result.execution.outcome == Outcome::not_graded || !result.score.variants) continue;
        points += final_scenes_points(result);
        most += result.score.variants->max_points;
    }
    return most > 0 ? fmt::format("    {:<22} {:>5.0f} %\n", "other scenes", 100 * points / most) : "";
}

std::string summary(const std::vector<Graded>& graded) {
    std::map<int, Tally> tallies;
    for (const Graded& result : graded) {
        if (result.execution.outcome == Outcome::not_graded) continue;
        for (const QuestionScore& question : result.score.questions) count(tallies[question.number], result, question);
    }
    std::string text = fmt::format("\n{:<26} {:>7}  {:>6} {:>10} {:>6} {:>7} {:>10}\n", "answers by question",
                                   "average", "right", "consistent", "wrong", "missing", "unreadable");
    for (const auto& [number, tally] : tallies) {
        const double share = tally.max_points > 0 ? 100 * tally.points / tally.max_points : 0;
        text += fmt::format("{:>2}  {:<22} {:>5.0f} %  {:>6} {:>10} {:>6} {:>7} {:>10}\n", number, tally.title, share,
                            tally.right, tally.follow, tally.wrong, tally.missing, tally.unreadable);
    }
    return text + scenes_summary(graded);
}

}  // namespace

std::string class_table(const std::vector<Graded>& graded, Colors colors) {
    if (graded.empty()) return "";
    std::size_t id_width = narrowest_id;
    const std::vector<std::string> names = names_in_table(graded);
    for (const std::string& name : names) id_width = std::max(id_width, std::min(widest_id, code_points(name)));
    std::string text = padded("submission", id_width) + fmt::format("  {:<13}", "outcome");
    for (const QuestionScore& question : graded.front().score.questions)
        text += fmt::format(" {:>5}", fmt::format("Q{}", question.number));
    const bool has_flags =
        std::ranges::any_of(graded, [](const Graded& result) { return !open_flags(result).empty(); });
    text += fmt::format("  {:>6}{}\n", "points", has_flags ? "   flags" : "");
    double sum = 0;
    std::size_t marked = 0, by_hand = 0;
    for (std::size_t i = 0; i < graded.size(); ++i) {
        const Graded& one = graded[i];
        text += row_of(one, names[i], id_width, colors);
        const auto points = points_that_count(one);
        if (!points) continue;
        sum += *points;
        ++marked;
        if (one.execution.outcome == Outcome::not_graded) ++by_hand;
    }
    text += departures(graded);
    constexpr std::size_t small_class = 2;  // whose rows say the same
    if (graded.size() > small_class) text += summary(graded);
    if (marked > 0) {
        text +=
            fmt::format("\n{} of {} graded{}, average {} of {} points\n", marked - by_hand, graded.size(),
                        by_hand > 0 ? fmt::format(", {} marked by hand", by_hand) : "",
                        points_text(sum / static_cast<double>(marked)), points_text(graded.front().score.max_points));
    }
    if (const std::string warning = sandbox_warning(graded.front().execution.tier); !warning.empty()) {
        text += fmt::format("\nWarning: {}\n", warning);
    }
    return text;
}

std::string needs_a_person(const std::vector<Graded>& graded, const std::string& way, Colors colors) {
    std::string flagged, ungraded;
    int count = 0;
    for (const Graded& result : graded) {
        const std::vector<Flag> open = open_flags(result);
        if (!open_concerns(result).empty()) ++count;
        for (const Flag& flag : open) {
            const ConcernTitle title = title_of(flag.kind);
            flagged += fmt::format("  {}: {}: {}{}\n", called(result.submission), one_line(title.in_a_line),
                                   shortened(evidence_text(result, flag, Audience::instructor)), title.way_out);
        }
        if (result.execution.outcome == Outcome::not_graded)
            ungraded += fmt::format("{} {}: {}\n", colored("not graded:", Color::red, colors),
                                    called(result.submission), one_line(result.execution.explanation));
    }
    if (count == 0) return ungraded;
    const std::string head = fmt::format("{} of {} to review with `{}`:", count, graded.size(), way);
    return fmt::format("\n{}\n{}{}", colored(head, Color::yellow, colors), flagged, ungraded);
}

}  // namespace harness::report
