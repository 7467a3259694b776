#include "harness/close_call.h"

#include <algorithm>

namespace harness {
namespace {

constexpr ItemId d{6, "d"}, t_s{6, "t"}, t_t{8, "t"}, u{8, "u"}, v{8, "v"}, hit_t{8, "hit"};

ItemId id_of(const reference::ItemSpec& spec) {
    return {spec.question, spec.name};
}

/// Everything that `known` may give for the item, by every derivation of it; for the sphere's t by the discriminant
/// alone.
std::vector<Target> results_of(const ItemId& id, const Known& known, const RealScene& scene, QuadraticForm form) {
    std::vector<Target> results;
    for (const Derivation& derivation : all_derivations()) {
        const auto& inputs = derivation.inputs;
        const bool past_discriminant = id == t_s && std::find(inputs.begin(), inputs.end(), d) == inputs.end();
        if (derivation.item != id || past_discriminant) continue;
        const std::vector<Target> more = derivation.compute(known, scene, form);
        results.insert(results.end(), more.begin(), more.end());
    }
    return results;
}

/// The key with the student's own values in it.
Known with_own_values(const Evidence& evidence) {
    Known known = evidence.key;
    for (const auto& [id, target] : evidence.own_values(Digits::as_printed)) known.set(id, target);
    return known;
}

/// Whether every value that was printed for an input of the item is right. What a wrong one decides is a matter of
/// following through.
bool has_right_inputs(const ItemId& id, const Evidence& evidence) {
    const auto is_right = [&](const ItemId& input) { return !evidence.deviating.contains(input); };
    const auto derivations = all_derivations();
    return std::all_of(derivations.begin(), derivations.end(), [&](const Derivation& derivation) {
        return derivation.item != id || std::all_of(derivation.inputs.begin(), derivation.inputs.end(), is_right);
    });
}

}  // namespace

bool is_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance) {
    const ItemId id = id_of(printed.spec);
    if (id != t_s && id != hit_t) return false;
    Evidence scratch = evidence;  // is_one_of may note a layout
    const auto may_be = [&](const Known& known, QuadraticForm form) {
        return is_one_of(printed, results_of(id, known, evidence.scene, form), scratch, allowance);
    };
    if (may_be(evidence.key, QuadraticForm::full)) return true;
    if (!has_right_inputs(id, evidence)) return false;
    const bool possible = std::any_of(evidence.float_keys.begin(), evidence.float_keys.end(),
                                      [&](const Known& key) { return may_be(key, QuadraticForm::full); });
    return possible && may_be(with_own_values(evidence), evidence.quadratic.form);
}

bool follows_from_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance) {
    if (evidence.close_calls.empty()) return false;
    Evidence right_values = evidence;
    right_values.deviating = evidence.close_calls;
    for (auto& own : right_values.own)
        std::erase_if(own, [&](const auto& entry) { return !evidence.right.contains(entry.first); });
    return follows(printed, right_values, allowance);
}

std::vector<reference::Verdict> close_verdicts(const Evidence& evidence) {
    std::vector<reference::Verdict> verdicts;
    for (const Known& key : evidence.float_keys) {
        std::vector<Target> sphere_ts = results_of(t_s, key, evidence.scene, QuadraticForm::full);
        if (const auto t = key.scalar(t_s)) sphere_ts.push_back(target_of(*t));
        for (const Target& sphere_t : sphere_ts) {
            HitValues values{{}, key.scalar(t_t), key.scalar(u), key.scalar(v)};
            if (!sphere_t.no_value) values.sphere_t = sphere_t.components.front();
            const auto more = possible_verdicts(values, evidence.scene.boundaries);
            verdicts.insert(verdicts.end(), more.begin(), more.end());
        }
    }
    return verdicts;
}

}  // namespace harness
