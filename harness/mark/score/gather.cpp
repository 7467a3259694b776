#include "harness/mark/score/gather.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/mark/compare/key_targets.h"
#include "harness/mark/diagnose/close_call.h"
#include "harness/mark/diagnose/residual.h"
#include "reference/key/graded_allowance.h"

namespace harness {
namespace {

using reference::KeyItem;
using reference::Shape;

using item::triangle::matrix, item::triangle::rhs;

/// Whether the value is so large that in float, adding the scene's numbers and their squares does not change it. Every
/// later value would then depend only on it. c and d are squares of lengths.
bool swallows_scene(const MatchedItem& printed, const IntervalScene& scene) {
    const bool is_square = printed.spec.id.name == "c" || printed.spec.id.name == "d";
    const double length = 0x1p24 * scene.size * scene.size, largest = is_square ? length * length : length;
    return std::ranges::any_of(printed.value->numbers,
                               [&](const PrintedNumber& number) { return std::abs(number.value) > largest; });
}

class Gatherer {
  public:
    Gatherer(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
             const reference::Assignment& assignment);
    Gathered gather();

  private:
    Finding compare_with_key(const KeyItem& item, const MatchedItem& printed);
    bool is_of_negated_system(const ItemId& id) const;
    Target target_for(const KeyItem& item, const reference::Answer& answer) const;
    Finding judge_residual(const MatchedItem& printed) const;
    bool is_right_but_coarse(const KeyItem& item, const MatchedItem& printed, int least_digits) const;
    std::optional<std::string> other_quadratic(const KeyItem& item, const MatchedItem& printed) const;
    std::optional<SystemForm> column_order(const KeyItem& item, const MatchedItem& printed) const;
    bool suits_negated_system(const KeyItem& item, const MatchedItem& printed) const;
    void remember_own_value(const ItemId& id, const MatchedItem& printed);

    const std::vector<MatchedItem>& matched_;
    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
    Evidence evidence_;
    ItemTargets own_;  ///< all readable printed values, for residuals
    bool system_is_negated_ = false;
};

Gatherer::Gatherer(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                   const reference::Assignment& assignment)
    : matched_(matched), key_(key), rubric_(assignment.rubric) {
    evidence_.conventions = keys_by_convention(key, rubric_);
    for (const ItemTargets& known : evidence_.conventions) evidence_.float_keys.push_back(widened_by_allowance(known));
    for (auto [id, target] : evidence_.conventions.front().targets()) {
        target.allowance.clear();  // derived values have their own allowances
        evidence_.key.set(id, std::move(target));
    }
    for (const MatchedItem& item : matched) {
        if (readable(matched, item.spec.id) != nullptr) own_.set(item.spec.id, own_value(item));
    }
    evidence_.scene = real_scene(assignment, key.canonical);
    evidence_.min_decimals = rubric_.min_decimals;
    for (const reference::Subject object : reference::objects) {
        const bool has_quadratic =
            std::ranges::count(reference::known_items(), ItemId{object, "d"}, &reference::Item::id) > 0;
        if (!has_quadratic) continue;
        const PrintedQuadratic printed{object,
                                       readable(matched_, {object, "a"}),
                                       readable(matched_, {object, "b"}),
                                       readable(matched_, {object, "c"}),
                                       readable(matched_, {object, "d"}),
                                       readable(matched_, {object, "t"})};
        evidence_.quadratics[object] = find_quadratic_scale(printed, evidence_.conventions, rubric_.min_decimals);
    }
}

Gathered Gatherer::gather() {
    Gathered gathered;
    for (const reference::KeyQuestion& question : key_.questions) {
        for (const KeyItem& item : question.items) {
            const ItemId id = item.spec.id;
            const MatchedItem* printed = readable(matched_, id);
            if (printed == nullptr) continue;
            const Finding finding = compare_with_key(item, *printed);
            if (!is_finite(*printed->value) || !swallows_scene(*printed, evidence_.scene))
                remember_own_value(id, *printed);
            if (!finding.right && !finding.coarse) evidence_.deviating.insert(id);
            const double allowance = allowance_of(item, rubric_);
            const bool close_call = !finding.right && (is_close_call(*printed, evidence_, allowance) ||
                                                       follows_from_close_call(*printed, evidence_, allowance));
            if (close_call) evidence_.close_calls.insert(id);
            if (finding.right || close_call) evidence_.right.insert(id);
            gathered.findings[id] = finding;
        }
    }
    gathered.evidence = std::move(evidence_);
    return gathered;
}

bool Gatherer::is_of_negated_system(const ItemId& id) const {
    return id == rhs && evidence_.system && evidence_.system->is_negated();
}

/// An answer of the key in the student's form: a right-hand side has the sign of its matrix.
Target Gatherer::target_for(const KeyItem& item, const reference::Answer& answer) const {
    Target target = target_with_allowance(item, answer, rubric_);
    return is_of_negated_system(item.spec.id) ? negated(std::move(target)) : target;
}

Finding Gatherer::compare_with_key(const KeyItem& item, const MatchedItem& printed) {
    const ItemId id = item.spec.id;
    Finding finding;
    for (const reference::Answer& answer : item.answers) {
        const Closeness closeness =
            compare(printed, target_for(item, answer), allowance_of(item, rubric_), rubric_.min_decimals);
        if (!finding.error) finding.error = closeness.error;
        if (!closeness.within) continue;
        if (!reference::float_can_answer(answer)) return judge_residual(printed);
        finding.right = true;
        finding.accepted_as =
            is_of_negated_system(id) ? negated_form().describe() : std::string(reference::reason(answer, key_));
        finding.error = closeness.error;
        if (id == matrix) evidence_.system = SystemForm{};
        return finding;
    }
    if (!printed.value->numbers.empty()) {
        std::optional<std::string> other_form;
        if (evidence_.quadratics.contains(id.subject) && item.spec.shape == Shape::scalar) {
            other_form = other_quadratic(item, printed);
        } else if (id == matrix) {
            evidence_.system = column_order(item, printed);
            if (evidence_.system) other_form = evidence_.system->describe();
        } else if (id == rhs && suits_negated_system(item, printed)) {
            other_form = negated_form().describe();
        }
        if (other_form) {
            finding.right = true;
            finding.accepted_as = *other_form;
            finding.error.reset();
        }
    }
    constexpr int digits_that_tell = 3;  // with fewer digits, too many different values round to the same number
    finding.coarse = !finding.right && is_right_but_coarse(item, printed, digits_that_tell);
    finding.too_short = !finding.right && is_right_but_coarse(item, printed, 0);
    return finding;
}

Finding Gatherer::judge_residual(const MatchedItem& printed) const {
    ItemTargets own = own_;
    for (const ItemId& id : {matrix, rhs}) {  // converted to the handout's form
        const auto& known = evidence_.own_values(Digits::as_printed);
        if (const auto found = known.find(id); found != known.end()) own.set(id, found->second);
    }
    Finding finding;
    switch (residual_of(printed, own, evidence_.scene)) {
        case Residual::small:
            finding.right = true;
            finding.accepted_as = "float has too few digits for this answer here; it agrees with your other answers";
            break;
        case Residual::unknown:
            finding.right = true;
            finding.accepted_as = "float has too few digits for this answer here; it counts unchecked";
            break;
        case Residual::impossible: finding.advice = residual_advice(printed.spec.id); break;
    }
    return finding;
}

/// Whether these are the key's values, rounded as printed. A number with fewer digits than `least_digits` counts as it
/// is; if that is 0, so do a whole number and one with the rubric's decimals.
bool Gatherer::is_right_but_coarse(const KeyItem& item, const MatchedItem& printed, int least_digits) const {
    const std::vector<PrintedNumber> numbers = by_columns(printed);
    return std::any_of(item.answers.begin(), item.answers.end(), [&](const reference::Answer& answer) {
        Target target = target_for(item, answer);
        for (std::size_t i = 0; i < std::min(numbers.size(), target.allowance.size()); ++i) {
            const bool is_short = numbers[i].decimals > 0 && numbers[i].decimals < rubric_.min_decimals;
            const bool is_rounded = is_short || least_digits > 0;
            if (is_rounded && !numbers[i].exact && numbers[i].significant >= least_digits)
                target.allowance[i] += 0.5 * std::pow(10.0, -numbers[i].decimals);
        }
        return compare(printed, target, 0.0, rubric_.min_decimals).within;
    });
}

/// A form other than the handout's in which a, b, c or d is right; empty if there is none.
std::optional<std::string> Gatherer::other_quadratic(const KeyItem& item, const MatchedItem& printed) const {
    const std::string_view name = printed.spec.id.name;
    const QuadraticScale scale = evidence_.quadratic_of(printed.spec.id.subject);
    const bool half = scale.form == QuadraticForm::half_b && (name == "b" || name == "d");
    const Interval& k = scale.factor;
    const Interval factor = name == "d" && !is_one(k) ? k * k : k;
    if (name == "t" || (!half && is_one(factor))) return std::nullopt;
    const Interval divisor(!half ? 1 : name == "b" ? 2 : 4);
    const bool right = std::any_of(item.answers.begin(), item.answers.end(), [&](const reference::Answer& answer) {
        const Target target = target_of(answer);
        return !target.no_value && is_multiple(printed.value->numbers.front(), target.components.front() / divisor,
                                               factor, allowance_of(item, rubric_), rubric_.min_decimals);
    });
    if (!right) return std::nullopt;
    return half ? "the form with b' = b/2 and d' = b'^2 - ac" : "the whole equation multiplied by a number";
}

/// The column order in which the matrix is right; empty if there is none.
std::optional<SystemForm> Gatherer::column_order(const KeyItem& item, const MatchedItem& printed) const {
    for (const reference::Answer& answer : item.answers) {
        if (auto order =
                find_column_order(printed, target_of(answer), allowance_of(item, rubric_), rubric_.min_decimals))
            return order;
    }
    return std::nullopt;
}

/// The sign of a right-hand side is that of its matrix. If no matrix shows the sign, both signs are right.
bool Gatherer::suits_negated_system(const KeyItem& item, const MatchedItem& printed) const {
    if (evidence_.system || readable(matched_, matrix) != nullptr) return false;
    return std::ranges::any_of(item.answers, [&](const reference::Answer& answer) {
        const Target target = target_with_allowance(item, answer, rubric_);
        return !target.no_value &&
               is_scaled_rhs(printed, target, negated_form(), allowance_of(item, rubric_), rubric_.min_decimals);
    });
}

void Gatherer::remember_own_value(const ItemId& id, const MatchedItem& printed) {
    for (const Digits digits : {Digits::of_stream, Digits::as_printed}) {
        Target own = !is_finite(*printed.value) ? no_value() : printed_target(printed, digits);
        if (id == matrix && !own.no_value) {
            const Target key =
                target_of(evidence_.key.matrix3(matrix).value_or(reference::Mat3<Interval>(Interval(0.0))));
            const PrintedSolution solution{readable(matched_, item::triangle::t), readable(matched_, item::triangle::u),
                                           readable(matched_, item::triangle::v)};
            const auto form = evidence_.system ? *evidence_.system
                                               : likeliest_column_order(printed, readable(matched_, rhs), solution, key,
                                                                        0.0, rubric_.min_decimals);
            own = in_handout_order(printed, form, digits);
            system_is_negated_ = form.is_negated();
        }
        if (id == rhs && system_is_negated_) own = negated(std::move(own));
        evidence_.own[digits == Digits::of_stream ? 0 : 1][id] = std::move(own);
    }
}

}  // namespace

Gathered gather(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
                const reference::Assignment& assignment) {
    return Gatherer(matched, key, assignment).gather();
}

const MatchedItem* readable(const std::vector<MatchedItem>& matched, const ItemId& id) {
    const auto found =
        std::find_if(matched.begin(), matched.end(), [&](const MatchedItem& m) { return m.spec.id == id; });
    return found != matched.end() && found->value && !found->unreadable ? &*found : nullptr;
}

double allowance_of(const KeyItem& item, const reference::Rubric& rubric) {
    constexpr double without_bound = 0.01;  // of the answer's size: near enough to be consistent
    const reference::Answer& answer = item.answers.front();
    if (!reference::float_can_answer(answer))
        return without_bound * reference::unit_of(std::get<reference::Numbers>(answer.value));
    const std::vector<double> allowances = target_with_allowance(item, answer, rubric).allowance;
    return allowances.empty() ? 0.0 : *std::max_element(allowances.begin(), allowances.end());
}

}  // namespace harness
