#include "harness/follow.h"

#include <algorithm>
#include <cmath>

namespace harness {
namespace {

/// A result wider than this, beside its size, says nothing about the printed value.
constexpr double widest_result = 0.05;

bool says_something(const Target& target) {
    return std::all_of(target.components.begin(), target.components.end(), [](const Real& x) {
        return x.is_bounded() && x.hi() - x.lo() <= widest_result * std::max(1.0, std::abs(x.lo() + x.hi()) / 2);
    });
}

bool agrees(const MatchedItem& printed, const Target& target, Evidence& evidence, double allowance) {
    const ItemId id{printed.spec.question, printed.spec.name};
    if (id == ItemId{8, "matrix"}) {
        const auto form = find_column_order(printed, target, allowance, evidence.min_decimals);
        if (form) evidence.system = form;
        return form.has_value();
    }
    if (id == ItemId{8, "rhs"} && evidence.system && evidence.system->is_scaled() && !target.no_value) {
        return is_scaled_rhs(printed, target, *evidence.system, allowance, evidence.min_decimals);
    }
    return compare(printed, target, allowance, evidence.min_decimals).within;
}

/// What is known when the student's own values are taken for those inputs whose bits are set in `choice`, and the key's
/// for the others. Empty when that is no fair choice: nothing was printed for such an input, or a printed one that is
/// not right is passed over.
std::optional<Known> choose(const Derivation& derivation, std::size_t choice, const Evidence& evidence, Digits digits) {
    const std::map<ItemId, Target>& own_values = evidence.own_values(digits);
    Known known = evidence.key;
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

/// Runs one derivation with every choice of inputs.
bool follows_by(const Derivation& derivation, const MatchedItem& printed, Evidence& evidence, double allowance,
                Digits digits) {
    const std::size_t choices = std::size_t{1} << derivation.inputs.size();
    for (std::size_t choice = 1; choice < choices; ++choice) {
        const auto known = choose(derivation, choice, evidence, digits);
        if (!known) continue;
        for (const QuadraticForm form : {evidence.quadratic.form, QuadraticForm::full}) {
            if (is_one_of(printed, derivation.compute(*known, evidence.scene, form), evidence, allowance)) return true;
        }
    }
    return false;
}

}  // namespace

bool is_one_of(const MatchedItem& printed, const std::vector<Target>& targets, Evidence& evidence, double allowance) {
    return std::any_of(targets.begin(), targets.end(), [&](const Target& target) {
        return says_something(target) && agrees(printed, target, evidence, allowance);
    });
}

bool follows(const MatchedItem& printed, Evidence& evidence, double allowance) {
    for (const Derivation& derivation : all_derivations()) {
        if (derivation.item != ItemId{printed.spec.question, printed.spec.name}) continue;
        for (const Digits digits : {Digits::of_stream, Digits::as_printed}) {
            if (follows_by(derivation, printed, evidence, allowance, digits)) return true;
        }
    }
    return false;
}

}  // namespace harness
