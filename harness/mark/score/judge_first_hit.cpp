// Question 10: which object the ray hits first.
#include <algorithm>
#include <array>

#include "harness/mark/diagnose/close_call.h"
#include "harness/mark/score/judge.h"

namespace harness {
namespace {

using reference::KeyItem;

/// The items that decide question 10.
constexpr std::array<ItemId, 4> deciding = {{item::sphere::t, item::triangle::t, item::triangle::u, item::triangle::v}};

}  // namespace

std::optional<HitValues> Judge::own_hits(const Evidence& evidence) const {
    const auto& own = evidence.own_values(Digits::as_printed);
    const auto sphere_t = own.find(item::sphere::t), triangle_t = own.find(item::triangle::t);
    if (sphere_t == own.end() || triangle_t == own.end()) return std::nullopt;
    const auto value = [](const Target& target) {
        return target.no_value ? std::nullopt : std::optional(target.components.front());
    };
    HitValues hits{value(sphere_t->second), value(triangle_t->second)};
    if (const auto u = own.find(item::triangle::u); u != own.end()) hits.u = value(u->second);
    if (const auto v = own.find(item::triangle::v); v != own.end()) hits.v = value(v->second);
    for (const auto& number : {hits.sphere_t, hits.triangle_t}) {
        if (number && !number->is_bounded()) return std::nullopt;
    }
    for (const reference::KeyQuestion& question : key_.questions) {
        for (const KeyItem& key_item : question.items) {
            const double allowance = allowance_of(key_item, rubric_);
            const bool t = key_item.spec.name == "t", uv = key_item.spec.name == "u" || key_item.spec.name == "v";
            if (t) hits.t_allowance = std::max(hits.t_allowance, allowance);
            if (uv) hits.uv_allowance = std::max(hits.uv_allowance, allowance);
        }
    }
    return hits;
}

bool Judge::is_same_wrong_t(const Evidence& evidence) const {
    const MatchedItem* sphere_t = readable(matched_, item::sphere::t);
    const MatchedItem* triangle_t = readable(matched_, item::triangle::t);
    if (sphere_t == nullptr || triangle_t == nullptr || sphere_t->value->numbers.empty() ||
        triangle_t->value->numbers.empty())
        return false;
    const bool wrong = !evidence.right.contains(item::sphere::t) || !evidence.right.contains(item::triangle::t);
    return wrong && sphere_t->value->numbers.front().value == triangle_t->value->numbers.front().value;
}

ItemVerdict Judge::judge_verdict(const KeyItem& item, const PrintedVerdict& printed, const Evidence& evidence,
                                 ItemScore& score) const {
    const auto contains = [&](const std::vector<reference::Verdict>& verdicts) {
        return std::find(verdicts.begin(), verdicts.end(), printed.verdict) != verdicts.end();
    };
    const std::optional<HitValues> hits = own_hits(evidence);
    const bool agrees_with_own = hits && contains(possible_verdicts(*hits, evidence.scene.boundaries));
    const auto answer = std::find_if(item.answers.begin(), item.answers.end(), [&](const reference::Answer& a) {
        return a.value == reference::Value(printed.verdict);
    });
    // Where the rubric accepts two verdicts, the student's is right if it agrees with the student's own values.
    if (answer != item.answers.end() && (item.answers.size() == 1 || !hits || agrees_with_own)) {
        score.accepted_as = reference::reason(*answer, key_);
        return ItemVerdict::right;
    }
    if (agrees_with_own && contains(close_verdicts(evidence))) {
        score.accepted_as = "rounding may decide here what is hit first";
        return ItemVerdict::right;
    }
    const bool own_deviates = std::any_of(deciding.begin(), deciding.end(),
                                          [&](const ItemId& id) { return evidence.deviating.contains(id); });
    const bool follows_own = hits && (agrees_with_own || printed.verdict == smaller_t(*hits));
    if (follows_own && own_deviates && !is_same_wrong_t(evidence)) return ItemVerdict::follow;
    if (hits && !follows_own) {
        score.diagnosis = "verdict against own values";
        score.advice =
            "The verdict does not agree with the values of t that you printed for the two objects; compare them again.";
    }
    return ItemVerdict::wrong;
}

}  // namespace harness
