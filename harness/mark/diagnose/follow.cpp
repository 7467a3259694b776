#include "harness/mark/diagnose/follow.h"

#include <algorithm>
#include <cmath>

#include "harness/mark/diagnose/derivations.h"
#include "harness/match/question_match.h"

namespace harness {
namespace {

/// A result that is wider than this, relative to its size, is too uncertain to compare with the printed value.
constexpr double widest_result = 0.05;

std::optional<Agreement> agrees(const MatchedItem& printed, const Target& target, const Evidence& evidence,
                                double allowance) {
    const ItemId id = printed.spec.id;
    if (id == item::triangle::matrix) {
        const auto form = find_column_order(printed, target, allowance, evidence.min_decimals);
        return form ? std::optional(Agreement{form}) : std::nullopt;
    }
    const bool is_rhs = id == item::triangle::rhs && !target.no_value;
    const auto is_rhs_of = [&](const SystemForm& form) {
        return is_scaled_rhs(printed, target, form, allowance, evidence.min_decimals);
    };
    const bool is_multiplied = is_rhs && evidence.system && evidence.system->is_scaled();
    bool within =
        is_multiplied ? is_rhs_of(*evidence.system) : compare(printed, target, allowance, evidence.min_decimals).within;
    if (is_rhs && !evidence.system) within = within || is_rhs_of(negated_form());
    return within ? std::optional(Agreement{}) : std::nullopt;
}

/// The known values: the inputs whose bits are set in `choice` have the student's values, the others the key's. Empty
/// if the choice takes an input that was not printed, skips a printed input that deviates, or takes no deviating input.
std::optional<ItemTargets> choose(const Derivation& derivation, std::size_t choice, const Evidence& evidence,
                                  Digits digits) {
    const std::map<ItemId, Target>& own_values = evidence.own_values(digits);
    ItemTargets known = evidence.key;
    bool deviates = false;
    for (std::size_t i = 0; i < derivation.inputs.size(); ++i) {
        const ItemId& input = derivation.inputs[i];
        const auto own = own_values.find(input);
        const bool chosen = (choice >> i & 1U) != 0;
        const bool must_be_chosen = own != own_values.end() && evidence.deviating.contains(input);
        if ((chosen && own == own_values.end()) || (!chosen && must_be_chosen)) return std::nullopt;
        if (!chosen) continue;
        known.set(input, own->second);
        deviates = deviates || evidence.deviating.contains(input);
    }
    return deviates ? std::optional(std::move(known)) : std::nullopt;
}

/// Whether the student printed all digits of these inputs that a C++ stream prints. If a result is too uncertain
/// to compare even then, float itself can't narrow it, as for a pixel 100,000 units away.
bool has_all_digits(const Derivation& derivation, const std::map<ItemId, Target>& own_values) {
    constexpr double of_six_digits = 2e-5;
    return std::ranges::all_of(derivation.inputs, [&](const ItemId& input) {
        const auto own = own_values.find(input);
        return own == own_values.end() || std::ranges::all_of(own->second.components, [](const Interval& x) {
                   return x.hi() - x.lo() <= of_six_digits * std::max(1.0, std::abs(x.lo()));
               });
    });
}

/// nan, infinity, or "none" where that is a possible answer.
bool is_no_number(const MatchedItem& printed) {
    return printed.value->numbers.empty() ? may_be_absent(printed.spec) : !is_finite(*printed.value);
}

/// Runs one derivation with every choice of inputs.
std::optional<Agreement> follows_by(const Derivation& derivation, const MatchedItem& printed, const Evidence& evidence,
                                    double allowance, Digits digits) {
    const bool has_digits = has_all_digits(derivation, evidence.own_values(digits));
    const std::size_t choices = std::size_t{1} << derivation.inputs.size();
    // A missing hit point does not explain a t that is nan.
    const bool is_circular = derivation.item.name == "t" && derivation.inputs.back().name == "hit";
    for (std::size_t choice = 1; choice < choices; ++choice) {
        const auto known = choose(derivation, choice, evidence, digits);
        if (!known) continue;
        for (const QuadraticForm form : {evidence.quadratic_of(printed.spec.id.subject).form, QuadraticForm::full}) {
            const std::vector<Target> results = derivation.compute(*known, evidence.scene, form);
            if (auto agreement = is_one_of(printed, results, evidence, allowance)) {
                agreement->form = form;
                return agreement;
            }
            for (const Target& target : results) {
                const bool is_vague = has_digits && !says_something(target) &&
                                      std::ranges::all_of(target.components, &Interval::is_bounded);
                const auto agreement = is_vague ? agrees(printed, target, evidence, allowance) : std::nullopt;
                if (agreement) return agreement;
            }
            const bool none = std::any_of(results.begin(), results.end(), [](const Target& t) { return t.no_value; });
            if (none && is_nan(*printed.value)) return Agreement{};
            const bool may_be_finite = std::ranges::any_of(
                results, [](const Target& target) { return !target.no_value && says_something(target); });
            if (!may_be_finite && !is_circular && is_no_number(printed) && !evidence.right.empty()) return Agreement{};
        }
    }
    return std::nullopt;
}

}  // namespace

bool says_something(const Target& target) {
    return std::all_of(target.components.begin(), target.components.end(), [](const Interval& x) {
        return x.is_bounded() && x.hi() - x.lo() <= widest_result * std::max(1.0, std::abs(x.lo() + x.hi()) / 2);
    });
}

std::optional<Agreement> is_one_of(const MatchedItem& printed, const std::vector<Target>& targets,
                                   const Evidence& evidence, double allowance) {
    for (const Target& target : targets) {
        if (!says_something(target)) continue;
        if (const auto agreement = agrees(printed, target, evidence, allowance)) return agreement;
    }
    return std::nullopt;
}

std::optional<Agreement> follows(const MatchedItem& printed, const Evidence& evidence, double allowance) {
    for (const Derivation& derivation : all_derivations()) {
        if (derivation.item != printed.spec.id) continue;
        for (const Digits digits : {Digits::of_stream, Digits::as_printed}) {
            if (const auto agreement = follows_by(derivation, printed, evidence, allowance, digits)) return agreement;
        }
    }
    return std::nullopt;
}

}  // namespace harness
