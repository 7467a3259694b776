#include "harness/report/class/story.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/record/final_mark.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

/// The named mistakes that the most students share, at most three.
std::vector<const WrongAnswer*> named_by_most(const std::vector<QuestionMistakes>& mistakes) {
    constexpr std::size_t most = 3;
    std::vector<const WrongAnswer*> answers;
    for (const QuestionMistakes& question : mistakes) {
        for (const WrongAnswer& answer : question.answers) {
            if (!answer.diagnosis.empty() && answer.who.size() > 1) answers.push_back(&answer);
        }
    }
    std::ranges::stable_sort(answers, std::ranges::greater(), [](const WrongAnswer* one) { return one->who.size(); });
    answers.resize(std::min(answers.size(), most));
    return answers;
}

std::string how_it_ended(Outcome outcome, std::size_t count) {
    const bool one = count == 1;
    switch (outcome) {
        case Outcome::graded: return "";
        case Outcome::compile_error: return one ? "does not compile" : "do not compile";
        case Outcome::crashed: return "crashed";
        case Outcome::timed_out: return "reached the time limit";
        case Outcome::output_limit: return "printed without end";
        case Outcome::memory_limit: return "took too much memory";
        case Outcome::no_output: return "printed nothing";
        case Outcome::not_graded: return one ? "is not graded" : "are not graded";
    }
    return "";
}

}  // namespace

std::string class_story(const ClassStatistics& statistics, const std::vector<Graded>& graded,
                        const std::vector<QuestionMistakes>& mistakes) {
    if (!statistics.median) return "";
    constexpr double nearly_all = 0.9, rounding = 1e-9;
    const auto has_nearly_all = [&](const Graded& one) {
        const auto points = points_that_count(one);
        return points && *points >= nearly_all * statistics.max_points - rounding;
    };
    std::string story = fmt::format("{} of {} have at least {} of {} points; the median is {}.",
                                    std::ranges::count_if(graded, has_nearly_all), statistics.marked,
                                    points_text(nearly_all * statistics.max_points), points_text(statistics.max_points),
                                    points_text(*statistics.median));
    std::string shared;
    for (const WrongAnswer* answer : named_by_most(mistakes)) {
        shared +=
            fmt::format("{}{} in question {} ({}: {})", shared.empty() ? " The same mistake was made by " : ", by ",
                        answer->who.size(), answer->spec.question, answer->spec.name, answer->diagnosis);
    }
    if (!shared.empty()) story += shared + ".";
    std::string ended;
    for (const OutcomeCount& each : statistics.outcomes) {
        const std::string how = how_it_ended(each.outcome, each.who.size());
        if (!how.empty()) ended += fmt::format("{}{} {}", ended.empty() ? " " : ", ", each.who.size(), how);
    }
    return story + (ended.empty() ? "" : ended + ".");
}

}  // namespace harness::report
