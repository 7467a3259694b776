#include "harness/judge.h"

#include <algorithm>
#include <cmath>

#include "harness/misconception.h"
#include "harness/own_verdict.h"

namespace harness {
namespace {

using reference::KeyItem;
using reference::Shape;

constexpr ItemId matrix{8, "matrix"}, rhs{8, "rhs"};

ItemId id_of(const reference::ItemSpec& spec) { return {spec.question, spec.name}; }

/// Where nothing bounds how far float arithmetic may be off, as at a tangent, an answer is held to this share of its size.
constexpr double allowance_without_bound = 0.01;

/// What a key without certified allowances is held to: some roundings of float, beside the item's size.
constexpr double uncertified_allowance = 1e-4;

}  // namespace

Judge::Judge(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key, const reference::Assignment& assignment)
    : matched_(matched), key_(key), rubric_(assignment.rubric) {
    double widest = 0;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            Target target = target_with_allowance(item, item.answers.front());
            for (const double allowance : target.allowance) widest = std::max(widest, question.number == 6 ? allowance : 0.0);
            target.allowance.clear();  // what follows from it has allowances of its own
            evidence_.key.set(id_of(item.spec), std::move(target));
        }
    }
    evidence_.scene = real_scene(assignment, key.canonical);
    evidence_.min_decimals = rubric_.min_decimals;
    const PrintedQuadratic quadratic{readable({6, "a"}), readable({6, "b"}), readable({6, "c"}), readable({6, "d"})};
    evidence_.quadratic = find_quadratic_scale(quadratic, evidence_.key, widest, rubric_.min_decimals);
    collect_evidence();
}

void Judge::collect_evidence() {
    for (const reference::KeyQuestion& question : key_.questions) {
        for (const KeyItem& item : question.items) {
            const MatchedItem* printed = readable(id_of(item.spec));
            if (printed == nullptr) continue;
            ItemScore score = start_score(item);
            const bool canonical = is_right(item, *printed, score) && score.accepted_as.empty();
            remember(*printed);
            if (!canonical) evidence_.deviating.insert(id_of(item.spec));
        }
    }
}

const MatchedItem* Judge::readable(const ItemId& id) const {
    const auto found = std::find_if(matched_.begin(), matched_.end(), [&](const MatchedItem& m) { return id_of(m.spec) == id; });
    return found != matched_.end() && found->value && !found->unreadable ? &*found : nullptr;
}

Target Judge::target_with_allowance(const KeyItem& item, const reference::Answer& answer) const {
    Target target = target_of(answer);
    const auto* numbers = std::get_if<reference::Numbers>(&answer.value);
    if (numbers == nullptr) return target;
    const double unit = reference::unit_of(*numbers);
    const double tolerance = unit * rubric_.tolerance_of(item.spec.question, std::string(item.spec.name)).value_or(0.0);
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        double allowance = answer.allowance.empty() ? uncertified_allowance * unit : answer.allowance[i];
        if (!std::isfinite(allowance)) allowance = allowance_without_bound * unit;
        target.allowance.push_back(std::max(allowance, tolerance));
    }
    return target;
}

ItemScore Judge::start_score(const KeyItem& item) const {
    ItemScore score;
    score.spec = item.spec;
    score.expected = item.answers.front().value;
    const std::vector<double> allowances = target_with_allowance(item, item.answers.front()).allowance;
    if (!allowances.empty()) score.allowance = *std::max_element(allowances.begin(), allowances.end());
    return score;
}

ItemScore Judge::judge(const KeyItem& item) {
    ItemScore score = start_score(item);
    const auto printed = std::find_if(matched_.begin(), matched_.end(), [&](const MatchedItem& m) { return id_of(m.spec) == id_of(item.spec); });
    if (printed == matched_.end()) return score;
    if (printed->verdict) {
        score.printed = printed->verdict->printed;
        score.line = printed->verdict->line;
        score.verdict = judge_verdict(item, *printed->verdict, score);
    } else if (printed->value) {
        score.printed = printed->value->printed;
        score.line = printed->value->line;
        score.verdict = printed->unreadable ? ItemVerdict::unreadable : judge_value(item, *printed, score);
    }
    return score;
}

ItemVerdict Judge::judge_value(const KeyItem& item, const MatchedItem& printed, ItemScore& score) {
    if (is_right(item, printed, score)) return ItemVerdict::right;
    if (follows(printed, evidence_, score.allowance)) return ItemVerdict::follow;
    if (id_of(item.spec) == matrix && is_right_multiplied(item, printed, score)) return ItemVerdict::right;
    if (const Misconception* mistake = find_misconception(printed, evidence_, score.allowance)) {
        score.diagnosis = mistake->name;
        score.advice = mistake->advice;
    }
    return ItemVerdict::wrong;
}

bool Judge::is_right(const KeyItem& item, const MatchedItem& printed, ItemScore& score) {
    for (const reference::Answer& answer : item.answers) {
        const Closeness closeness = compare(printed, target_with_allowance(item, answer), score.allowance, rubric_.min_decimals);
        if (!score.error) score.error = closeness.error;
        if (!closeness.within) continue;
        score.accepted_as = reference::reason(answer, key_);
        score.error = closeness.error;
        if (id_of(item.spec) == matrix) evidence_.system = SystemForm{};
        return true;
    }
    if (printed.value->numbers.empty()) return false;
    if (item.spec.question == 6 && item.spec.shape == Shape::scalar && is_right_quadratic(printed, score)) return true;
    if (id_of(item.spec) == matrix) return is_right_matrix(item, printed, score);
    return id_of(item.spec) == rhs && is_right_rhs(item, printed, score);
}

bool Judge::is_right_quadratic(const MatchedItem& printed, ItemScore& score) const {
    const auto expected = evidence_.key.scalar(id_of(printed.spec));
    const bool half = evidence_.quadratic.form == QuadraticForm::half_b;
    const double k = evidence_.quadratic.factor;
    double factor = k;
    if (printed.spec.name == "b") factor = half ? k / 2 : k;
    if (printed.spec.name == "d") factor = half ? k * k / 4 : k * k;
    if (!expected || printed.spec.name == "t" || factor == 1.0) return false;
    const double slack = score.allowance * std::max(1.0, std::abs(factor));
    if (!is_within(printed.value->numbers.front(), *expected * Real(factor), slack, rubric_.min_decimals)) return false;
    score.accepted_as = half ? "the form with b' = b/2 and d' = b'^2 - ac" : "the whole equation multiplied by a number";
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

bool Judge::is_right_multiplied(const KeyItem& item, const MatchedItem& printed, ItemScore& score) {
    const auto key_rhs = evidence_.key.vector(rhs);
    if (!key_rhs || printed.value->numbers.empty()) return false;
    const auto form = find_multiplied_form(printed, readable(rhs), target_of(item.answers.front()), target_of(*key_rhs),
                                           score.allowance, rubric_.min_decimals);
    if (!form) return false;
    evidence_.system = form;
    score.accepted_as = form->describe();
    score.error.reset();
    return true;
}

bool Judge::is_right_rhs(const KeyItem& item, const MatchedItem& printed, ItemScore& score) const {
    if (!evidence_.system || !evidence_.system->is_scaled()) return false;
    const Target scaled = scaled_rhs(target_of(item.answers.front()), *evidence_.system);
    if (!compare(printed, scaled, score.allowance, rubric_.min_decimals).within) return false;
    score.accepted_as = evidence_.system->describe();
    score.error.reset();
    return true;
}

ItemVerdict Judge::judge_verdict(const KeyItem& item, const PrintedVerdict& printed, ItemScore& score) const {
    const OwnHits hits{readable({6, "t"}), readable({8, "t"}), readable({8, "u"}), readable({8, "v"})};
    const std::vector<reference::Verdict> own = own_verdicts(hits, rubric_.min_decimals);
    const bool agrees_with_own = std::find(own.begin(), own.end(), printed.verdict) != own.end();
    const auto answer = std::find_if(item.answers.begin(), item.answers.end(),
                                     [&](const reference::Answer& a) { return a.value == reference::Value(printed.verdict); });
    if (answer != item.answers.end()) {
        // Where the rubric accepts two verdicts, the student's is right if it agrees with the student's own values.
        if (item.answers.size() == 1 || own.empty() || agrees_with_own) {
            score.accepted_as = reference::reason(*answer, key_);
            return ItemVerdict::right;
        }
    } else if (agrees_with_own) {
        return ItemVerdict::follow;
    }
    if (!own.empty() && !agrees_with_own) {
        score.diagnosis = "verdict against own values";
        score.advice = "The verdict does not agree with the values of t that you printed for the two objects; compare them again.";
    }
    return ItemVerdict::wrong;
}

void Judge::remember(const MatchedItem& printed) {
    const ItemId id = id_of(printed.spec);
    for (const Digits digits : {Digits::of_stream, Digits::as_printed}) {
        Target own = printed_target(printed, digits);
        if (id == matrix && !own.no_value) {
            const Target key = target_of(evidence_.key.matrix3(matrix).value_or(reference::Mat3<Real>(Real(0.0))));
            own = in_handout_order(printed, evidence_.system.value_or(nearest_column_order(printed, key)), digits);
        }
        evidence_.own[digits == Digits::of_stream ? 0 : 1][id] = std::move(own);
    }
}

}  // namespace harness
