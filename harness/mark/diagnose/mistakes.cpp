#include "harness/mark/diagnose/mistakes.h"

#include "harness/mark/diagnose/follow.h"
#include "harness/mark/diagnose/mistake_parts.h"

namespace harness {
namespace {

/// Whether the mistake's result is so far from the key's value that a printed value cannot be near both. Otherwise the
/// mistake is not named.
bool tells_from_key(const Target& result, const Target& key, double allowance) {
    if (result.no_value != key.no_value || result.components.size() != key.components.size()) return true;
    for (std::size_t i = 0; i < result.components.size(); ++i) {
        const Interval difference = result.components[i] - key.components[i];
        if (difference.lo() > 2 * allowance || difference.hi() < -2 * allowance) return true;
    }
    return false;
}

std::optional<Agreement> explains(const Mistake& mistake, const std::vector<ItemTargets>& known,
                                  const MatchedItem& printed, const Evidence& evidence, double allowance) {
    // The named mistakes in b and d use the handout's form.
    const bool is_halved = evidence.quadratic_of(mistake.item.subject).form == QuadraticForm::half_b;
    if (is_halved && (mistake.item.name == "b" || mistake.item.name == "d")) return std::nullopt;
    const auto key = evidence.key.targets().find(mistake.item);
    for (const ItemTargets& values : known) {
        std::vector<Target> results = mistake.compute(values, evidence.scene);
        if (key != evidence.key.targets().end())
            std::erase_if(results, [&](const Target& r) { return !tells_from_key(r, key->second, allowance); });
        if (const auto agreement = is_one_of(printed, results, evidence, allowance)) return agreement;
    }
    return std::nullopt;
}

/// The student's values, with b and d in the handout's form, in which the named mistakes compute.
ItemTargets own_in_full_form(const Evidence& evidence, reference::Subject object, Digits digits) {
    ItemTargets known = evidence.with_own(digits);
    if (evidence.quadratic_of(object).form != QuadraticForm::half_b) return known;
    const auto own_b = known.scalar({object, "b"}), own_d = known.scalar({object, "d"});
    if (own_b) known.set({object, "b"}, target_of(Interval(2) * *own_b));
    if (own_d) known.set({object, "d"}, target_of(Interval(4) * *own_d));
    return known;
}

/// The mistakes that explain the printed value if earlier answers have the known values.
std::optional<FoundMistake> find_among(const std::vector<ItemTargets>& known, const MatchedItem& printed,
                                       const Evidence& evidence, double allowance, std::string_view name) {
    std::optional<FoundMistake> first,
        negated;  // (-V | A-B | A-C) has its edges the wrong way round, rather than V, negated
    for (const Mistake& mistake : all_mistakes()) {
        if (mistake.item != printed.spec.id || !(name.empty() || mistake.name == name)) continue;
        const auto agreement = explains(mistake, known, printed, evidence, allowance);
        if (!agreement) continue;
        const FoundMistake found{&mistake, agreement->system};
        if (agreement->system && agreement->system->is_negated()) {
            if (!negated) negated = found;
        } else if (mistake.name == root_behind_start) {
            return found;  // its formula is right; one that gives the same number only because a = 1 or d = 0 is not
                           // the reason
        } else if (!first) {
            first = found;
        } else if (mistake.name != first->mistake->name) {
            first->others.push_back(&mistake);
        }
    }
    return first ? first : negated;
}

}  // namespace

std::span<const Mistake> all_mistakes() {
    static const std::vector<Mistake> table = [] {
        std::vector<Mistake> all = mistakes::of<reference::Subject::camera>();
        reference::for_each_object([&]<reference::Subject object>() {
            const std::vector<Mistake>& more = mistakes::of<object>();
            all.insert(all.end(), more.begin(), more.end());
        });
        return all;
    }();
    return table;
}

std::optional<FoundMistake> find_mistake(const MatchedItem& printed, const Evidence& evidence, double allowance,
                                         std::string_view name) {
    const reference::Subject object = printed.spec.id.subject;
    const auto found = find_among(
        {own_in_full_form(evidence, object, Digits::of_stream), own_in_full_form(evidence, object, Digits::as_printed)},
        printed, evidence, allowance, name);
    return found ? found : find_among({evidence.key}, printed, evidence, allowance, name);
}

}  // namespace harness
