#include "harness/judge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/misconception.h"
#include "harness/tolerance.h"

namespace harness {
namespace {

using reference::KeyItem;
using reference::Shape;

constexpr ItemId matrix{8, "matrix"}, rhs{8, "rhs"};

/// What question 10 is decided by.
constexpr std::array<ItemId, 4> deciding = {{{6, "t"}, {8, "t"}, {8, "u"}, {8, "v"}}};

ItemId id_of(const reference::ItemSpec& spec) {
    return {spec.question, spec.name};
}

/// Whether float would lose the scene's numbers, and their squares, beside such a one: what follows from it is the
/// number itself.
bool swallows_scene(const PrintedValue& value, const RealScene& scene) {
    const double largest = 0x1p24 * scene.size * scene.size;
    return std::any_of(value.numbers.begin(), value.numbers.end(),
                       [&](const PrintedNumber& number) { return std::abs(number.value) > largest; });
}

void note_reading(ItemScore& score, const PrintedValue& value) {
    score.no_value = value.numbers.empty();
    for (const PrintedNumber& number : value.numbers) {
        score.not_finite = score.not_finite || !std::isfinite(number.value);
        if (!number.exact) score.half_unit = std::max(score.half_unit, 0.5 * std::pow(10.0, -number.decimals));
    }
}

}  // namespace

Judge::Judge(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
             const reference::Assignment& assignment)
    : matched_(matched), key_(key), rubric_(assignment.rubric) {
    evidence_.conventions = keys_by_convention(key, rubric_);
    for (const Known& known : evidence_.conventions) evidence_.float_keys.push_back(widened_by_allowance(known));
    for (auto [id, target] : evidence_.conventions.front().targets()) {
        target.allowance.clear();  // what follows from it has allowances of its own
        evidence_.key.set(id, std::move(target));
    }
    evidence_.scene = real_scene(assignment, key.canonical);
    evidence_.min_decimals = rubric_.min_decimals;
    const PrintedQuadratic quadratic{readable({6, "a"}), readable({6, "b"}), readable({6, "c"}), readable({6, "d"})};
    evidence_.quadratic = find_quadratic_scale(quadratic, evidence_.conventions, rubric_.min_decimals);
    collect_evidence();
}

void Judge::collect_evidence() {
    for (const reference::KeyQuestion& question : key_.questions) {
        for (const KeyItem& item : question.items) {
            if (const MatchedItem* printed = readable(id_of(item.spec))) remember(item, *printed);
        }
    }
}

void Judge::remember(const KeyItem& item, const MatchedItem& printed) {
    const ItemId id = id_of(item.spec);
    ItemScore score = start_score(item);
    const bool right = is_right(item, printed, score);
    const bool usable = !swallows_scene(*printed.value, evidence_.scene);
    for (const Digits digits : {Digits::of_stream, Digits::as_printed}) {
        if (!usable) break;
        Target own = printed_target(printed, digits);
        if (id == matrix && !own.no_value) {
            const Target key = target_of(evidence_.key.matrix3(matrix).value_or(reference::Mat3<Real>(Real(0.0))));
            const PrintedSolution solution{readable({8, "t"}), readable({8, "u"}), readable({8, "v"})};
            const auto form = evidence_.system
                                  ? *evidence_.system
                                  : likeliest_column_order(printed, readable(rhs), solution, key, rubric_.min_decimals);
            own = in_handout_order(printed, form, digits);
        }
        evidence_.own[digits == Digits::of_stream ? 0 : 1][id] = std::move(own);
    }
    if (!right && !is_right_but_coarse(item, printed)) evidence_.deviating.insert(id);
    const bool close_call = !right && (is_close_call(printed, evidence_, score.allowance) ||
                                       follows_from_close_call(printed, evidence_, score.allowance));
    if (close_call) evidence_.close_calls.insert(id);
    if (right || close_call) evidence_.right.insert(id);
}

void Judge::forget(const ItemId& id) {
    for (auto& own : evidence_.own) own.erase(id);
}

const MatchedItem* Judge::readable(const ItemId& id) const {
    const auto found =
        std::find_if(matched_.begin(), matched_.end(), [&](const MatchedItem& m) { return id_of(m.spec) == id; });
    return found != matched_.end() && found->value && !found->unreadable ? &*found : nullptr;
}

ItemScore Judge::start_score(const KeyItem& item) const {
    ItemScore score;
    score.spec = item.spec;
    const std::vector<double> allowances = target_with_allowance(item, item.answers.front(), rubric_).allowance;
    if (!allowances.empty()) score.allowance = *std::max_element(allowances.begin(), allowances.end());
    return score;
}

ItemScore Judge::judge(const KeyItem& item) {
    ItemScore score = start_score(item);
    const auto printed = std::find_if(matched_.begin(), matched_.end(),
                                      [&](const MatchedItem& m) { return id_of(m.spec) == id_of(item.spec); });
    if (printed == matched_.end()) return score;
    if (printed->verdict) {
        score.printed = printed->verdict->printed;
        score.line = printed->verdict->line;
        score.verdict = judge_verdict(item, *printed->verdict, score);
    } else if (printed->value) {
        score.printed = printed->value->printed;
        score.line = printed->value->line;
        note_reading(score, *printed->value);
        score.verdict = printed->unreadable ? ItemVerdict::unreadable : judge_value(item, *printed, score);
    }
    return score;
}

ItemVerdict Judge::judge_value(const KeyItem& item, const MatchedItem& printed, ItemScore& score) {
    const ItemId id = id_of(item.spec);
    if (is_right(item, printed, score)) return ItemVerdict::right;
    if (evidence_.close_calls.contains(id)) {
        score.accepted_as = printed.value->numbers.empty() ? "the ray does not hit here"
                                                           : "rounding may decide here whether the ray hits";
        score.error.reset();
        return ItemVerdict::right;
    }
    if (is_right_but_coarse(item, printed)) {
        score.diagnosis = "too few decimals";
        score.advice = "As far as it goes this is right, but it is rounded too much; print more decimals.";
        return ItemVerdict::wrong;
    }
    if (follows(printed, evidence_, score.allowance)) return ItemVerdict::follow;
    if (id == matrix && is_right_multiplied(printed, score)) return ItemVerdict::right;
    if (printed.value->numbers.empty()) forget(id);  // nothing follows from a wrong "none"
    if (const Misconception* mistake = find_misconception(printed, evidence_, score.allowance)) {
        score.diagnosis = mistake->name;
        score.advice = mistake->advice;
    }
    return ItemVerdict::wrong;
}

bool Judge::is_right_but_coarse(const KeyItem& item, const MatchedItem& printed) const {
    constexpr int digits_that_tell = 3;  // "1" rounds too many values to tell which was meant
    const std::vector<PrintedNumber> numbers = by_columns(printed);
    return std::any_of(item.answers.begin(), item.answers.end(), [&](const reference::Answer& answer) {
        Target target = target_with_allowance(item, answer, rubric_);
        for (std::size_t i = 0; i < std::min(numbers.size(), target.allowance.size()); ++i) {
            if (numbers[i].significant >= digits_that_tell)
                target.allowance[i] += 0.5 * std::pow(10.0, -numbers[i].decimals);
        }
        return compare(printed, target, 0.0, rubric_.min_decimals).within;
    });
}

bool Judge::is_right(const KeyItem& item, const MatchedItem& printed, ItemScore& score) {
    for (const reference::Answer& answer : item.answers) {
        const Closeness closeness =
            compare(printed, target_with_allowance(item, answer, rubric_), score.allowance, rubric_.min_decimals);
        if (!score.error) score.error = closeness.error;
        if (!closeness.within) continue;
        score.accepted_as = reference::reason(answer, key_);
        score.error = closeness.error;
        if (id_of(item.spec) == matrix) evidence_.system = SystemForm{};
        return true;
    }
    if (printed.value->numbers.empty()) return false;
    if (item.spec.question == 6 && item.spec.shape == Shape::scalar) return is_right_quadratic(item, printed, score);
    if (id_of(item.spec) == matrix) return is_right_matrix(item, printed, score);
    return id_of(item.spec) == rhs && is_right_rhs(item, printed, score);
}

bool Judge::is_right_quadratic(const KeyItem& item, const MatchedItem& printed, ItemScore& score) const {
    const std::string_view name = printed.spec.name;
    const bool half = evidence_.quadratic.form == QuadraticForm::half_b && (name == "b" || name == "d");
    const Real& k = evidence_.quadratic.factor;
    const Real factor = name == "d" && !is_one(k) ? k * k : k;
    if (name == "t" || (!half && is_one(factor))) return false;
    const Real divisor(!half ? 1 : name == "b" ? 2 : 4);
    const bool right = std::any_of(item.answers.begin(), item.answers.end(), [&](const reference::Answer& answer) {
        const Target target = target_of(answer);
        return !target.no_value && is_multiple(printed.value->numbers.front(), target.components.front() / divisor,
                                               factor, score.allowance, rubric_.min_decimals);
    });
    if (!right) return false;
    score.accepted_as =
        half ? "the form with b' = b/2 and d' = b'^2 - ac" : "the whole equation multiplied by a number";
    score.error.reset();
    return true;
}

bool Judge::is_right_matrix(const KeyItem& item, const MatchedItem& printed, ItemScore& score) {
    for (const reference::Answer& answer : item.answers) {
        evidence_.system = find_column_order(printed, target_of(answer), score.allowance, rubric_.min_decimals);
        if (!evidence_.system) continue;
        score.accepted_as = evidence_.system->describe();
        score.error.reset();
        return true;
    }
    return false;
}

bool Judge::is_right_multiplied(const MatchedItem& printed, ItemScore& score) {
    if (printed.value->numbers.empty()) return false;
    for (const Known& key : evidence_.conventions) {
        const auto system = key.targets().find(matrix), right_side = key.targets().find(rhs);
        if (system == key.targets().end() || right_side == key.targets().end()) continue;
        evidence_.system = find_multiplied_form(printed, readable(rhs), system->second, right_side->second,
                                                score.allowance, rubric_.min_decimals);
        if (!evidence_.system) continue;
        score.accepted_as = evidence_.system->describe();
        score.error.reset();
        return true;
    }
    return false;
}

bool Judge::is_right_rhs(const KeyItem& item, const MatchedItem& printed, ItemScore& score) const {
    if (!evidence_.system || !evidence_.system->is_scaled()) return false;
    const bool right = std::any_of(item.answers.begin(), item.answers.end(), [&](const reference::Answer& answer) {
        return is_scaled_rhs(printed, target_of(answer), *evidence_.system, score.allowance, rubric_.min_decimals);
    });
    if (!right) return false;
    score.accepted_as = evidence_.system->describe();
    score.error.reset();
    return true;
}

std::optional<HitValues> Judge::own_hits() const {
    const auto& own = evidence_.own_values(Digits::as_printed);
    const auto sphere_t = own.find({6, "t"}), triangle_t = own.find({8, "t"});
    if (sphere_t == own.end() || triangle_t == own.end()) return std::nullopt;
    const auto value = [](const Target& target) {
        return target.no_value ? std::nullopt : std::optional(target.components.front());
    };
    HitValues hits{value(sphere_t->second), value(triangle_t->second)};
    if (const auto u = own.find({8, "u"}); u != own.end()) hits.u = value(u->second);
    if (const auto v = own.find({8, "v"}); v != own.end()) hits.v = value(v->second);
    for (const auto& number : {hits.sphere_t, hits.triangle_t}) {
        if (number && !number->is_bounded()) return std::nullopt;
    }
    for (const reference::KeyQuestion& question : key_.questions) {
        for (const KeyItem& key_item : question.items) {
            const double allowance = start_score(key_item).allowance;
            const bool t = key_item.spec.name == "t", uv = key_item.spec.name == "u" || key_item.spec.name == "v";
            if (t) hits.t_allowance = std::max(hits.t_allowance, allowance);
            if (uv) hits.uv_allowance = std::max(hits.uv_allowance, allowance);
        }
    }
    return hits;
}

bool Judge::is_same_wrong_t() const {
    const MatchedItem* sphere_t = readable({6, "t"});
    const MatchedItem* triangle_t = readable({8, "t"});
    if (sphere_t == nullptr || triangle_t == nullptr || sphere_t->value->numbers.empty() ||
        triangle_t->value->numbers.empty())
        return false;
    const bool wrong = !evidence_.right.contains({6, "t"}) || !evidence_.right.contains({8, "t"});
    return wrong && sphere_t->value->numbers.front().value == triangle_t->value->numbers.front().value;
}

ItemVerdict Judge::judge_verdict(const KeyItem& item, const PrintedVerdict& printed, ItemScore& score) const {
    const auto contains = [&](const std::vector<reference::Verdict>& verdicts) {
        return std::find(verdicts.begin(), verdicts.end(), printed.verdict) != verdicts.end();
    };
    const std::optional<HitValues> hits = own_hits();
    const bool agrees_with_own = hits && contains(possible_verdicts(*hits, evidence_.scene.boundaries));
    const auto answer = std::find_if(item.answers.begin(), item.answers.end(), [&](const reference::Answer& a) {
        return a.value == reference::Value(printed.verdict);
    });
    // Where the rubric accepts two verdicts, the student's is right if it agrees with the student's own values.
    if (answer != item.answers.end() && (item.answers.size() == 1 || !hits || agrees_with_own)) {
        score.accepted_as = reference::reason(*answer, key_);
        return ItemVerdict::right;
    }
    if (agrees_with_own && contains(close_verdicts(evidence_))) {
        score.accepted_as = "rounding may decide here what is hit first";
        return ItemVerdict::right;
    }
    const bool own_deviates = std::any_of(deciding.begin(), deciding.end(),
                                          [&](const ItemId& id) { return evidence_.deviating.contains(id); });
    const bool follows_own = hits && (agrees_with_own || printed.verdict == smaller_t(*hits));
    if (follows_own && own_deviates && !is_same_wrong_t()) return ItemVerdict::follow;
    if (hits && !follows_own) {
        score.diagnosis = "verdict against own values";
        score.advice =
            "The verdict does not agree with the values of t that you printed for the two objects; compare them again.";
    }
    return ItemVerdict::wrong;
}

}  // namespace harness
