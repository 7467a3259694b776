#include "harness/report/text/look_first.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/report/text/sentences.h"
#include "harness/text/listed.h"

namespace harness::report {
namespace {

bool any(const QuestionScore& question, ItemVerdict verdict) {
    return std::any_of(question.items.begin(), question.items.end(),
                       [&](const ItemScore& item) { return item.verdict == verdict; });
}

bool is_wrong_itself(const QuestionScore& question) {
    return any(question, ItemVerdict::wrong) || any(question, ItemVerdict::unreadable);
}

bool only_follows(const QuestionScore& question) {
    return any(question, ItemVerdict::follow) && !is_wrong_itself(question) && !any(question, ItemVerdict::missing);
}

/// "Question 3 lacks", "Questions 3, 4 and 6 lack".
std::string subject(const std::vector<int>& questions, const char* of_one, const char* of_many) {
    std::vector<std::string> numbers;
    for (const int question : questions) numbers.push_back(std::to_string(question));
    const bool one = numbers.size() == 1;
    return fmt::format("{} {} {}", one ? "Question" : "Questions", listed(numbers), one ? of_one : of_many);
}

}  // namespace

bool holds_no_answer(const Score& score) {
    return std::all_of(score.questions.begin(), score.questions.end(), [](const QuestionScore& question) {
        return std::all_of(question.items.begin(), question.items.end(),
                           [](const ItemScore& item) { return item.verdict == ItemVerdict::missing; });
    });
}

bool is_without_answers(const Graded& graded) {
    return graded.execution.outcome != Outcome::graded && holds_no_answer(graded.score);
}

std::optional<LookFirst> look_first(const Graded& graded) {
    if (holds_no_answer(graded.score)) return std::nullopt;
    const std::vector<QuestionScore>& questions = graded.score.questions;
    const auto wrong = std::find_if(questions.begin(), questions.end(), is_wrong_itself);
    const auto missing = std::find_if(questions.begin(), questions.end(),
                                      [](const QuestionScore& q) { return any(q, ItemVerdict::missing); });
    auto first = wrong != questions.end() ? wrong : missing;
    const bool ended_early = was_cut_short(graded.execution.outcome);
    if (first == questions.end() && graded.findings.own_scene)
        first = std::ranges::find_if(questions, [](const QuestionScore& q) { return q.points < q.max_points; });
    if (first == questions.end()) return std::nullopt;
    LookFirst look{first->number,
                   graded.findings.own_scene ? graded.findings.own_scene->cause : "",
                   wrong == questions.end(),
                   ended_early,
                   std::count_if(questions.begin(), questions.end(), is_wrong_itself) == 1,
                   {},
                   {}};
    for (const QuestionScore& question : questions) {
        const bool lacks = any(question, ItemVerdict::missing) && !is_wrong_itself(question);
        if (lacks && !look.is_missing && !ended_early) look.lacking.push_back(question.number);
        if (only_follows(question) && look.own_scene.empty()) look.following.push_back(question.number);
    }
    return look;
}

std::string reason(const LookFirst& look) {
    if (!look.own_scene.empty()) return look.own_scene + ". Most of the lost points come from that.";
    if (look.is_missing && look.ended_early) return "the program ended before it printed all of its answers.";
    std::string text = "it is the first one with a missing answer.";
    if (!look.is_missing)
        text = look.is_only ? "it is the only one with a wrong answer." : "it has your first wrong answer.";
    if (!look.lacking.empty()) text += fmt::format(" {} answers.", subject(look.lacking, "lacks", "lack"));
    if (look.following.empty()) return text;
    const bool one = look.following.size() == 1;
    const bool from_it = look.is_only && !look.is_missing && look.following.front() > look.question;
    return text + fmt::format(" {} consistent with {} and {} no mistake of {} own.",
                              subject(look.following, "is", "are"), from_it ? "it" : "your earlier answers",
                              one ? "has" : "have", one ? "its" : "their");
}

std::string invitation(const LookFirst& look) {
    if (!look.own_scene.empty()) return "Start with the scene in your source";
    const bool is_of_end = look.ended_early && !look.is_missing;  // it was printed before the program ended
    return fmt::format("{} question {}", is_of_end ? "Then look at" : "Start with", look.question);
}

std::string look_first_sentence(const Graded& graded) {
    const std::optional<LookFirst> look = look_first(graded);
    return look ? fmt::format("{}: {}", invitation(*look), reason(*look)) : "";
}

}  // namespace harness::report
