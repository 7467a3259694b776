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

/// Runs one derivation with every choice of inputs.
bool follows_by(const Derivation& derivation, const MatchedItem& printed, Evidence& evidence, double allowance,
                Digits digits) {
    const std::map<ItemId, Target>& own_values = evidence.own_values(digits);
    const std::size_t choices = std::size_t{1} << derivation.inputs.size();
    for (std::size_t choice = 1; choice < choices; ++choice) {
        Known known = evidence.key;
        bool possible = true;
        bool deviates = false;
        for (std::size_t i = 0; i < derivation.inputs.size(); ++i) {
            if ((choice >> i & 1U) == 0) continue;
            const auto own = own_values.find(derivation.inputs[i]);
            possible = possible && own != own_values.end();
            if (!possible) break;
            known.set(own->first, own->second);
            deviates = deviates || evidence.deviating.contains(own->first);
        }
        if (!possible || !deviates) continue;
        for (const QuadraticForm form : {evidence.quadratic.form, QuadraticForm::full}) {
            if (is_one_of(printed, derivation.compute(known, evidence.scene, form), evidence, allowance)) return true;
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
