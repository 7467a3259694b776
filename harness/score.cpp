#include "harness/score.h"

#include <algorithm>

#include "harness/judge.h"

namespace harness {
namespace {

double share_of(ItemVerdict verdict, const reference::Rubric& rubric) {
    switch (verdict) {
        case ItemVerdict::right: return 1.0;
        case ItemVerdict::follow: return rubric.follow_through;
        case ItemVerdict::wrong:
        case ItemVerdict::missing:
        case ItemVerdict::unreadable: return 0.0;
    }
    return 0.0;
}

/// How bad a verdict is for its question.
int rank(ItemVerdict verdict) {
    switch (verdict) {
        case ItemVerdict::right: return 0;
        case ItemVerdict::follow: return 1;
        case ItemVerdict::missing: return 2;
        case ItemVerdict::unreadable:
        case ItemVerdict::wrong: return 3;
    }
    return 3;
}

/// The item's points: as the rubric lists them, else an equal share of the question's.
double item_points(const reference::Rubric& rubric, const reference::KeyQuestion& question,
                   const reference::ItemSpec& spec) {
    const auto listed = rubric.item_points.find(question.number);
    if (listed == rubric.item_points.end())
        return rubric.points_of(question.number) / static_cast<double>(question.items.size());
    const auto points = listed->second.find(std::string(spec.name));
    return points == listed->second.end() ? 0.0 : points->second;
}

QuestionScore score_question(const reference::KeyQuestion& question, Judge& judge, const reference::Rubric& rubric) {
    QuestionScore score;
    score.number = question.number;
    score.max_points = rubric.points_of(question.number);
    double lost = 0;  // counted down from the whole, so that a question without a mistake has exactly its points
    for (const reference::KeyItem& item : question.items) {
        ItemScore judged = judge.judge(item);
        judged.max_points = item_points(rubric, question, item.spec);
        judged.points = judged.max_points * share_of(judged.verdict, rubric);
        lost += judged.max_points - judged.points;
        if (rank(judged.verdict) > rank(score.verdict)) score.verdict = judged.verdict;
        score.items.push_back(std::move(judged));
    }
    const bool nothing =
        std::all_of(score.items.begin(), score.items.end(), [](const ItemScore& item) { return item.points == 0; });
    score.points = nothing ? 0.0 : score.max_points - lost;
    if (score.verdict == ItemVerdict::unreadable) score.verdict = ItemVerdict::wrong;
    return score;
}

}  // namespace

std::string_view to_string(ItemVerdict verdict) {
    switch (verdict) {
        case ItemVerdict::right: return "right";
        case ItemVerdict::follow: return "follow";
        case ItemVerdict::wrong: return "wrong";
        case ItemVerdict::missing: return "missing";
        case ItemVerdict::unreadable: return "unreadable";
    }
    return "";
}

Score score(const Transcript& transcript, const reference::AnswerKey& key, const reference::Assignment& assignment) {
    std::vector<reference::ItemSpec> items;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items) items.push_back(item.spec);
    }
    const std::vector<MatchedItem> matched = match(transcript, items);
    Judge judge(matched, key, assignment);
    Score score;
    for (const reference::KeyQuestion& question : key.questions) {
        score.questions.push_back(score_question(question, judge, assignment.rubric));
        score.points += score.questions.back().points;
        score.max_points += score.questions.back().max_points;
    }
    return score;
}

}  // namespace harness
