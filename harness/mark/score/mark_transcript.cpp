#include "harness/mark/score/mark_transcript.h"

#include <algorithm>

#include "harness/mark/score/doubt.h"
#include "harness/mark/score/gather.h"
#include "harness/mark/score/judge.h"
#include "harness/match/match.h"

namespace harness {
namespace {

/// The share of its points that an answer earns before the rubric's cap.
double share_of(const ItemScore& item, const reference::Rubric& rubric) {
    switch (item.verdict) {
        case ItemVerdict::right: return 1.0;
        case ItemVerdict::follow: return item.credit.value_or(rubric.follow_through);
        case ItemVerdict::wrong: return item.credit.value_or(0.0);
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

ItemVerdict worst_verdict(const std::vector<ItemScore>& items) {
    ItemVerdict worst = ItemVerdict::right;
    for (const ItemScore& item : items) {
        if (rank(item.verdict) > rank(worst)) worst = item.verdict;
    }
    return worst == ItemVerdict::unreadable ? ItemVerdict::wrong : worst;
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

/// Judges the items, and adds the results to the evidence; award() gives the points.
QuestionScore judge_question(const reference::KeyQuestion& question, const Judge& judge, Evidence& evidence,
                             const reference::Rubric& rubric) {
    QuestionScore score;
    score.number = question.number;
    score.title = question.title;
    score.max_points = rubric.points_of(question.number);
    score.items.reserve(question.items.size());
    for (const reference::KeyItem& item : question.items) {
        Judgement judgement = judge.judge(item, evidence);
        learn(evidence, judgement);
        ItemScore judged = std::move(judgement.score);
        judged.max_points = item_points(rubric, question, item.spec);
        score.items.push_back(std::move(judged));
    }
    score.verdict = worst_verdict(score.items);
    return score;
}

/// The points of all follow-through answers before the rubric's cap.
double followed_points(const Score& score, const reference::Rubric& rubric) {
    double sum = 0;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items)
            sum += item.verdict == ItemVerdict::follow ? item.max_points * share_of(item, rubric) : 0.0;
    }
    return sum;
}

/// `cut` is the share of follow-through points that the rubric's cap leaves.
void award(QuestionScore& question, const reference::Rubric& rubric, double cut) {
    double lost = 0;  // subtracted from the maximum, so that a question without a mistake gets exactly its points
    for (ItemScore& item : question.items) {
        const double left = item.verdict == ItemVerdict::follow ? cut : 1.0;
        item.points = item.max_points * share_of(item, rubric) * left;
        lost += item.max_points - item.points;
    }
    const bool nothing = std::all_of(question.items.begin(), question.items.end(),
                                     [](const ItemScore& item) { return item.points == 0; });
    question.points = nothing ? 0.0 : question.max_points - lost;
}

void award_points(Score& score, const reference::Rubric& rubric) {
    const double followed = followed_points(score, rubric);
    const double cap = rubric.follow_through_cap * score.max_points;
    double cut = 1.0;
    score.follow_cap.reset();
    score.points = 0;
    if (followed > cap) {
        score.follow_cap = cap;
        cut = cap / followed;
    }
    for (QuestionScore& question : score.questions) {
        award(question, rubric, cut);
        score.points += question.points;
    }
}

/// Whether an answer is more than yes or no, so that it is unlikely to be right by chance.
bool is_number(const ItemScore& item) {
    return item.spec.shape != reference::Shape::first_object && !item.no_value && !item.not_finite &&
           !item.printed.empty();
}

bool is_right(const ItemScore& item) {
    return item.verdict == ItemVerdict::right;
}

/// How well a scene explains an answer: best if the answer is right, then if it is consistent, then if it is a known
/// mistake.
int explanation(const ItemScore& item) {
    if (is_right(item)) return 3;
    if (item.verdict == ItemVerdict::follow) return 2;
    return item.verdict == ItemVerdict::wrong && !item.diagnosis.empty() ? 1 : 0;
}

/// The item's score for an answer that is not right for the assignment, given its score under the scene of the
/// student's source.
ItemScore explained(const ItemScore& item, const ItemScore& own, const reference::Rubric& rubric) {
    const bool follows_there = own.verdict == ItemVerdict::right || own.verdict == ItemVerdict::follow;
    const double credit = rubric.wrong_scene_credit * (is_right(own) ? 1.0 : rubric.follow_through);
    ItemScore result = item;
    if (is_right(own)) result.doubt.reset();
    if (item.verdict == ItemVerdict::follow && (!follows_there || rubric.follow_through >= credit)) return result;
    result.diagnosis = follows_there ? own_scene_diagnosis : own.diagnosis;
    result.advice = follows_there ? "" : own.advice;
    const bool may_be_shown = own.spec.shape == reference::Shape::first_object && !result.advice.empty();
    if (may_be_shown) result.advice += " This may show only because of the different scene in your source.";
    result.mistakes = own.mistakes;
    result.difference = follows_there ? "" : own.difference;
    if (!follows_there) return result;
    result.verdict = ItemVerdict::follow;
    result.credit = credit;
    return result;
}

std::vector<ItemScore*> items_of(Score& score) {
    std::vector<ItemScore*> items;
    for (QuestionScore& question : score.questions) {
        for (ItemScore& item : question.items) items.push_back(&item);
    }
    return items;
}

/// The orders in which a matrix may have been printed, besides the one in which it was read. GLM's columns may be rows
/// only if each is on its own line.
std::vector<MatrixOrder> other_orders(const MatchedItem& printed) {
    constexpr std::size_t fewest = 9;
    if (!printed.value || printed.value->numbers.size() < fewest) return {};
    if (printed.order == MatrixOrder::rows) return {MatrixOrder::columns};
    if (printed.order == MatrixOrder::unsaid) return {MatrixOrder::rows, MatrixOrder::columns};
    if (printed.value->last_line > printed.value->line) return {MatrixOrder::rows};
    return {};
}

/// Doubts the wrong answers that are not wrong in `otherwise`, the score with this matrix in another order, if no other
/// answer gets a worse verdict there. An answer that was computed with the matrix would get a worse one if the matrix
/// was wrong in the program too.
void doubt_order(const std::vector<ItemScore*>& items, Score otherwise, const MatchedItem& matrix) {
    const std::vector<ItemScore*> others = items_of(otherwise);
    const bool suits = std::ranges::equal(others, items, [&](const ItemScore* a, const ItemScore* b) {
        return rank(a->verdict) <= rank(b->verdict) || a->spec.id == matrix.spec.id;
    });
    for (std::size_t i = 0; suits && i < items.size(); ++i) {
        const bool is_explained =
            items[i]->verdict == ItemVerdict::wrong && rank(others[i]->verdict) < rank(ItemVerdict::wrong);
        if (is_explained && !is_settled(*items[i])) items[i]->doubt = Doubt{Doubt::Why::by_columns, matrix.value->line};
    }
}

/// Tries every matrix in its other orders. One that is right in the order that its lines state is not questioned.
void doubt_orders(Score& score, std::vector<MatchedItem> matched, const reference::AnswerKey& key,
                  const reference::Assignment& assignment) {
    const std::vector<ItemScore*> items = items_of(score);
    if (std::ranges::none_of(items, [](const ItemScore* item) { return item->verdict == ItemVerdict::wrong; })) return;
    for (MatchedItem& printed : matched) {
        const MatrixOrder own = printed.order;
        const auto scored =
            std::ranges::find(items, printed.spec.id, [](const ItemScore* item) { return item->spec.id; });
        if (own != MatrixOrder::unsaid && (*scored)->verdict == ItemVerdict::right) continue;
        for (const MatrixOrder other : other_orders(printed)) {
            printed.order = other;
            doubt_order(items, mark_answers(matched, key, assignment), printed);
            printed.order = own;
        }
    }
}

}  // namespace

Score mark_answers(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                   const reference::Assignment& assignment) {
    Gathered gathered = gather(matched, key, assignment);
    const Judge judge(matched, gathered.findings, key, assignment);
    Score score;
    score.questions.reserve(key.questions.size());
    for (const reference::KeyQuestion& question : key.questions) {
        score.questions.push_back(judge_question(question, judge, gathered.evidence, assignment.rubric));
        score.max_points += score.questions.back().max_points;
    }
    award_points(score, assignment.rubric);
    return score;
}

Score score(const Transcript& transcript, const reference::AnswerKey& key, const reference::Assignment& assignment,
            std::span<const ItemPlace> places) {
    std::vector<reference::ItemSpec> items;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items) items.push_back(item.spec);
    }
    const std::vector<MatchedItem> matched = match(transcript, items, places);
    Score score = mark_answers(matched, key, assignment);
    doubt_readings(score, transcript, matched, key, assignment);
    doubt_orders(score, matched, key, assignment);
    return score;
}

std::ptrdiff_t answers_of(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                          const reference::Assignment& assignment) {
    const Gathered gathered = gather(matched, key, assignment);
    return std::ranges::count_if(gathered.findings, [](const auto& finding) { return finding.second.right; });
}

std::optional<Score> explained_by_scene(const Score& score, const Score& own, const std::string& cause,
                                        const reference::Rubric& rubric) {
    Score result = score;
    int gained = 0, lost = 0;
    bool told = false;
    for (std::size_t q = 0; q < score.questions.size(); ++q) {
        QuestionScore& question = result.questions[q];
        for (std::size_t i = 0; i < question.items.size(); ++i) {
            ItemScore& item = question.items[i];
            const ItemScore& there = own.questions.at(q).items.at(i);
            if (is_number(item)) {
                gained += std::max(explanation(there) - explanation(item), 0);
                lost += std::max(explanation(item) - explanation(there), 0);
            }
            if (is_right(item)) continue;
            item = explained(item, there, rubric);
            if (item.diagnosis != own_scene_diagnosis) continue;
            item.advice = told ? "It is consistent with the scene in your source."
                               : cause + ". This answer is consistent with that scene.";
            told = true;
        }
        question.verdict = worst_verdict(question.items);
    }
    // One or two answers may be right for the assignment's scene by chance, if mistakes cancel each other.
    constexpr int at_least = 2;
    if (gained < at_least || gained <= lost) return std::nullopt;
    award_points(result, rubric);
    return result;
}

}  // namespace harness
