// The order of the checks that lead to a verdict.
#include "harness/mark/score/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "harness/mark/compare/key_targets.h"
#include "harness/mark/diagnose/difference.h"
#include "harness/mark/diagnose/follow.h"
#include "harness/mark/diagnose/mistakes.h"
#include "reference/key/graded_allowance.h"

namespace harness {
namespace {

using reference::KeyItem;

using item::triangle::matrix, item::triangle::rhs;

void note_reading(ItemScore& score, const PrintedValue& value) {
    score.no_value = value.numbers.empty();
    for (const PrintedNumber& number : value.numbers) {
        score.not_finite = score.not_finite || !std::isfinite(number.value);
        if (!number.exact) score.half_unit = std::max(score.half_unit, 0.5 * std::pow(10.0, -number.decimals));
    }
}

/// Whether a value is so simple that many mistakes give it, such as -8, 0.25 and (0, 0, 2).
bool is_simple(const PrintedValue& value) {
    constexpr double unit = 0.125;
    const auto is_zero = [](const PrintedNumber& number) { return number.value == 0; };
    const auto is_round = [](const PrintedNumber& number) { return std::remainder(number.value, unit) == 0; };
    return std::ranges::count_if(value.numbers, std::not_fn(is_zero)) <= 1 &&
           std::ranges::all_of(value.numbers, is_round);
}

/// The most generous price first, because several mistakes may give the same answer.
std::vector<reference::MistakePrice> by_share(std::vector<reference::MistakePrice> prices) {
    std::ranges::stable_sort(prices, std::ranges::greater(), &reference::MistakePrice::share);
    return prices;
}

void accept(ItemScore& score, std::string reason) {
    score.verdict = ItemVerdict::right;
    score.accepted_as = std::move(reason);
    score.error.reset();
}

void price_mistake(const Mistake& mistake, double share, ItemScore& score) {
    if (share == 1) return accept(score, fmt::format("the rubric accepts the mistake \"{}\"", mistake.name));
    score.diagnosis = mistake.name;
    score.advice = fmt::format("{} The rubric gives it {:g} % of the points.", mistake.advice, 100 * share);
    score.credit = share;
}

/// The advice on a mistake. A program that takes either root goes wrong only when one is behind the start of the ray,
/// which an earlier mistake in the quadratic may cause.
std::string told_advice(const Mistake& mistake, const Evidence& evidence) {
    const bool is_wrong_quadratic = std::ranges::any_of(std::array{"a", "b", "c", "d"}, [&](std::string_view name) {
        return evidence.deviating.contains({mistake.item.subject, name});
    });
    const bool was_hidden = mistake.name == root_behind_start && is_wrong_quadratic;
    return fmt::format("{}{}", mistake.advice, was_hidden ? made_visible : "");
}

}  // namespace

void learn(Evidence& evidence, const Judgement& judgement) {
    if (judgement.system) evidence.system = judgement.system;
    const ItemId& id = judgement.score.spec.id;
    // A d that is b^2 - ac is wrong for a b in the full form, whatever the reason for b.
    if (judgement.form && id.name == "b") evidence.quadratics[id.subject].form = *judgement.form;
    if (!judgement.says_nothing) return;
    for (auto& own : evidence.own) own.erase(id);
}

Judgement Judge::judge(const KeyItem& item, const Evidence& evidence) const {
    Judgement judgement;
    ItemScore& score = judgement.score;
    score.spec = item.spec;
    score.allowance =
        reference::float_can_answer(item.answers.front()) ? std::optional(allowance_of(item, rubric_)) : std::nullopt;
    const auto printed =
        std::find_if(matched_.begin(), matched_.end(), [&](const MatchedItem& m) { return m.spec.id == item.spec.id; });
    if (printed == matched_.end()) return judgement;
    (printed->by_experiment ? score.experiment : score.reread) = printed->place_note;
    score.by_order = printed->by_order;
    if (printed->several_line != 0) score.doubt = Doubt{Doubt::Why::another_answer, printed->several_line};
    if (printed->first_object) {
        score.printed = printed->first_object->printed;
        score.line = score.last_line = printed->first_object->line;
        score.verdict = judge_first_object(item, *printed->first_object, evidence, score);
    } else if (printed->value) {
        score.printed = printed->value->printed;
        score.line = printed->value->line;
        score.last_line = printed->value->last_line;
        note_reading(score, *printed->value);
        score.verdict = ItemVerdict::unreadable;
        if (!printed->unreadable) judge_value(item, *printed, evidence, judgement);
        score.by_columns = printed->order == MatrixOrder::columns && score.verdict != ItemVerdict::right;
    }
    return judgement;
}

void Judge::judge_value(const KeyItem& item, const MatchedItem& printed, const Evidence& evidence,
                        Judgement& judgement) const {
    const ItemId id = item.spec.id;
    const Finding& finding = findings_.at(id);
    const bool is_empty = printed.value->numbers.empty();
    const double allowance = allowance_of(item, rubric_);
    ItemScore& score = judgement.score;
    score.verdict = ItemVerdict::wrong;
    score.error = finding.error;
    if (finding.right) {
        score.verdict = ItemVerdict::right;
        score.accepted_as = finding.accepted_as;
        return;
    }
    if (id == rhs && is_right_rhs(item, printed, evidence))
        return accept(score, evidence.system.value_or(negated_form()).describe());
    if (evidence.close_calls.contains(id)) {
        return accept(score, is_empty ? "the ray does not hit here" : "rounding may decide here whether the ray hits");
    }
    // If an earlier answer is wrong, a number near the key's is probably consistent with it.
    const auto agreement =
        finding.coarse && evidence.deviating.empty() ? std::nullopt : follows(printed, evidence, allowance);
    if (agreement) {
        score.verdict = ItemVerdict::follow;
        judgement.system = agreement->system;
        judgement.form = agreement->form;
        return;
    }
    if (finding.coarse) {
        score.diagnosis = "too few decimals";
        score.advice = "This is right but rounded too much; print more decimals.";
        return;
    }
    if (id == matrix && !is_empty) {
        judgement.system = multiplied_form(printed, evidence, allowance);
        if (judgement.system) return accept(score, judgement.system->describe());
    }
    judgement.says_nothing = is_empty || (is_nan(*printed.value) && evidence.right.empty());
    name_mistake(printed, evidence, allowance, judgement);
}

/// Names the kind of mistake: one that the rubric prices, else the first that fits, else another description.
void Judge::name_mistake(const MatchedItem& printed, const Evidence& evidence, double allowance,
                         Judgement& judgement) const {
    const ItemId id = printed.spec.id;
    ItemScore& score = judgement.score;
    Evidence without_this;  // nothing follows from a wrong "none"
    if (judgement.says_nothing) {
        without_this = evidence;
        learn(without_this, judgement);
    }
    const Evidence& known = judgement.says_nothing ? without_this : evidence;
    for (const reference::MistakePrice& price : by_share(rubric_.mistakes)) {
        if (price.item && *price.item != id) continue;
        const auto found = find_mistake(printed, known, allowance, price.name);
        if (!found) continue;
        judgement.system = found->system;
        return price_mistake(*found->mistake, price.share, score);
    }
    score.difference = difference(printed, known, allowance);
    const auto found = find_mistake(printed, known, allowance);
    if (!found) {
        const Finding& finding = findings_.at(id);
        score.advice = finding.advice;
        if (finding.too_short) {
            score.advice =
                fmt::format("This has too few digits to tell whether it is right; print at least {} decimals.",
                            std::max(rubric_.min_decimals, 2));
        }
        return;
    }
    judgement.system = found->system;
    score.mistakes.emplace_back(found->mistake->name, told_advice(*found->mistake, known));
    for (const Mistake* other : found->others) score.mistakes.emplace_back(other->name, told_advice(*other, known));
    score.may_be_chance = !found->others.empty() || is_simple(*printed.value);
    std::tie(score.diagnosis, score.advice) = in_words(score.mistakes);
}

std::optional<SystemForm> Judge::multiplied_form(const MatchedItem& printed, const Evidence& evidence,
                                                 double allowance) const {
    for (const ItemTargets& key : evidence.conventions) {
        const auto system = key.targets().find(matrix), right_side = key.targets().find(rhs);
        if (system == key.targets().end() || right_side == key.targets().end()) continue;
        if (auto form = find_multiplied_form(printed, readable(matched_, rhs), system->second, right_side->second,
                                             allowance, rubric_.min_decimals)) {
            return form;
        }
    }
    return std::nullopt;
}

bool Judge::is_right_rhs(const KeyItem& item, const MatchedItem& printed, const Evidence& evidence) const {
    if (printed.value->numbers.empty() || (evidence.system && !evidence.system->is_scaled())) return false;
    const SystemForm form = evidence.system.value_or(negated_form());
    return std::any_of(item.answers.begin(), item.answers.end(), [&](const reference::Answer& answer) {
        return is_scaled_rhs(printed, target_of(answer), form, allowance_of(item, rubric_), rubric_.min_decimals);
    });
}

}  // namespace harness
