#include "harness/mark/score/score.h"

#include <algorithm>

#include "harness/mark/score/doubt.h"
#include "harness/mark/score/judge.h"

namespace harness {
namespace {

/// `follow` is the share that a follow-through answer earns.
double share_of(ItemVerdict verdict, double follow) {
    switch (verdict) {
        case ItemVerdict::right: return 1.0;
        case ItemVerdict::follow: return follow;
        case ItemVerdict::wrong:
        case ItemVerdict::missing:
        case ItemVerdict::unreadable: return 0.0;
    }
    return 0.0;
}

/// How bad a verdict is for its question; larger is worse.
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

/// The item's points as the rubric lists them; else an equal share of the question's points.
double item_points(const reference::Rubric& rubric, const reference::KeyQuestion& question,
                   const reference::ItemSpec& spec) {
    const auto listed = rubric.item_points.find(question.number);
    if (listed == rubric.item_points.end())
        return rubric.points_of(question.number) / static_cast<double>(question.items.size());
    const auto points = listed->second.find(std::string(spec.name));
    return points == listed->second.end() ? 0.0 : points->second;
}

/// Judges the items and adds to the evidence what they tell; leaves the points for award().
QuestionScore judge_question(const reference::KeyQuestion& question, const Judge& judge, Evidence& evidence,
                             const reference::Rubric& rubric) {
    QuestionScore score;
    score.number = question.number;
    score.max_points = rubric.points_of(question.number);
    score.items.reserve(question.items.size());
    for (const reference::KeyItem& item : question.items) {
        Judgement judgement = judge.judge(item, evidence);
        learn(evidence, judgement);
        ItemScore judged = std::move(judgement.score);
        judged.max_points = item_points(rubric, question, item.spec);
        if (rank(judged.verdict) > rank(score.verdict)) score.verdict = judged.verdict;
        score.items.push_back(std::move(judged));
    }
    if (score.verdict == ItemVerdict::unreadable) score.verdict = ItemVerdict::wrong;
    return score;
}

/// The full points of all follow-through answers, before the follow-through share applies.
double followed_points(const Score& score) {
    double sum = 0;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) sum += item.verdict == ItemVerdict::follow ? item.max_points : 0.0;
    }
    return sum;
}

void award(QuestionScore& question, double follow) {
    double lost = 0;  // subtracted from the maximum, so that a question without a mistake gets exactly its points
    for (ItemScore& item : question.items) {
        item.points = item.max_points * share_of(item.verdict, follow);
        lost += item.max_points - item.points;
    }
    const bool nothing = std::all_of(question.items.begin(), question.items.end(),
                                     [](const ItemScore& item) { return item.points == 0; });
    question.points = nothing ? 0.0 : question.max_points - lost;
}

void award_points(Score& score, const reference::Rubric& rubric) {
    double follow = rubric.follow_through;
    const double followed = followed_points(score) * follow;
    const double cap = rubric.follow_through_cap * score.max_points;
    if (followed > cap) {
        score.follow_cap = cap;
        follow *= cap / followed;
    }
    for (QuestionScore& question : score.questions) {
        award(question, follow);
        score.points += question.points;
    }
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

std::string_view to_string(Doubt::Why why) {
    switch (why) {
        case Doubt::Why::right_elsewhere: return "right_elsewhere";
        case Doubt::Why::numbers_left: return "numbers_left";
        case Doubt::Why::words_left: return "words_left";
        case Doubt::Why::printed_again: return "printed_again";
        case Doubt::Why::little_read: return "little_read";
    }
    return "";
}

Score score(const Transcript& transcript, const reference::AnswerKey& key, const reference::Assignment& assignment) {
    std::vector<reference::ItemSpec> items;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items) items.push_back(item.spec);
    }
    const std::vector<MatchedItem> matched = match(transcript, items);
    Gathered gathered = gather(matched, key, assignment);
    const Judge judge(matched, gathered.findings, key, assignment);
    Score score;
    score.questions.reserve(key.questions.size());
    for (const reference::KeyQuestion& question : key.questions) {
        score.questions.push_back(judge_question(question, judge, gathered.evidence, assignment.rubric));
        score.max_points += score.questions.back().max_points;
    }
    award_points(score, assignment.rubric);
    doubt_readings(score, transcript, matched, key, assignment);
    return score;
}

}  // namespace harness
