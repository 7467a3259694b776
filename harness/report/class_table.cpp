#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/clean_text.h"
#include "harness/report/report.h"

namespace harness::report {
namespace {

constexpr std::size_t widest_id = 28;

/// Cuts or fills to a width in code points, as near as a table gets to columns.
std::string padded(std::string_view text, std::size_t width) {
    std::string result;
    std::size_t columns = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
        if (starts && columns == width) break;
        if (starts) ++columns;
        result += text[i];
    }
    return result + std::string(width - std::min(width, columns), ' ');
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::replace(text.begin(), text.end(), '\t', ' ');
    return escape_control(text);
}

std::size_t code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string row_of(const Graded& graded, std::size_t id_width) {
    std::string row =
        fmt::format("{}  {:<13}", padded(one_line(graded.submission.id), id_width), to_string(graded.outcome));
    const bool marked = graded.outcome != Outcome::not_graded;
    for (const QuestionScore& question : graded.score.questions)
        row += fmt::format(" {:>5}", marked ? points_text(question.points) : "-");
    return row + fmt::format("  {:>6}\n", marked ? points_text(graded.score.points) : "-");
}

struct Tally {
    int right = 0, follow = 0, wrong = 0, missing = 0, unreadable = 0;
    double points = 0, max_points = 0;
};

void count(Tally& tally, const QuestionScore& question) {
    tally.points += question.points;
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

std::string summary(const std::vector<Graded>& graded) {
    std::map<int, Tally> tallies;
    for (const Graded& one : graded) {
        if (one.outcome == Outcome::not_graded) continue;
        for (const QuestionScore& question : one.score.questions) count(tallies[question.number], question);
    }
    std::string text = fmt::format("\n{:<26} {:>7}  {:>6} {:>6} {:>6} {:>7} {:>10}\n", "question", "average", "right",
                                   "follow", "wrong", "missing", "unreadable");
    for (const auto& [number, tally] : tallies) {
        const double share = tally.max_points > 0 ? 100 * tally.points / tally.max_points : 0;
        text += fmt::format("{:>2}  {:<22} {:>5.0f} %  {:>6} {:>6} {:>6} {:>7} {:>10}\n", number,
                            reference::question_title(number), share, tally.right, tally.follow, tally.wrong,
                            tally.missing, tally.unreadable);
    }
    return text;
}

}  // namespace

std::string class_table(const std::vector<Graded>& graded) {
    if (graded.empty()) return "";
    std::size_t id_width = 10;
    for (const Graded& one : graded)
        id_width = std::max(id_width, std::min(widest_id, code_points(one_line(one.submission.id))));
    std::string text = padded("submission", id_width) + fmt::format("  {:<13}", "outcome");
    for (const QuestionScore& question : graded.front().score.questions)
        text += fmt::format(" {:>5}", fmt::format("Q{}", question.number));
    text += fmt::format("  {:>6}\n", "points");
    double sum = 0;
    std::size_t marked = 0;
    for (const Graded& one : graded) {
        text += row_of(one, id_width);
        if (one.outcome == Outcome::not_graded) continue;
        sum += one.score.points;
        ++marked;
    }
    text += summary(graded);
    if (marked > 0) {
        text +=
            fmt::format("\n{} of {} graded, average {} of {} points\n", marked, graded.size(),
                        points_text(sum / static_cast<double>(marked)), points_text(graded.front().score.max_points));
    }
    if (const std::string warning = sandbox_warning(graded.front().tier); !warning.empty()) {
        text += fmt::format("\nWarning: {}\n", warning);
    }
    for (const Graded& one : graded) {
        if (one.outcome == Outcome::not_graded)
            text += fmt::format("not graded: {}: {}\n", one_line(one.submission.id), one_line(one.explanation));
    }
    return text;
}

}  // namespace harness::report
