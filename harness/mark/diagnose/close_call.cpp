#include "harness/mark/diagnose/close_call.h"

#include <algorithm>

#include "harness/mark/diagnose/derivations.h"

namespace harness {
namespace {

/// All values that the item's derivations give from `known`; for the sphere's t, only derivations that use the
/// discriminant.
std::vector<Target> results_of(const ItemId& id, const ItemTargets& known, const IntervalScene& scene,
                               QuadraticForm form) {
    std::vector<Target> results;
    for (const Derivation& derivation : all_derivations()) {
        const auto& inputs = derivation.inputs;
        const bool past_discriminant =
            id == item::sphere::t && std::find(inputs.begin(), inputs.end(), item::sphere::d) == inputs.end();
        if (derivation.item != id || past_discriminant) continue;
        const std::vector<Target> more = derivation.compute(known, scene, form);
        results.insert(results.end(), more.begin(), more.end());
    }
    return results;
}

/// The key, with the student's values where they exist.
ItemTargets with_own_values(const Evidence& evidence) {
    ItemTargets known = evidence.key;
    for (const auto& [id, target] : evidence.own_values(Digits::as_printed)) known.set(id, target);
    return known;
}

/// Whether every printed input of the item is right. If an input is wrong, follow-through decides instead.
bool has_right_inputs(const ItemId& id, const Evidence& evidence) {
    const auto is_right = [&](const ItemId& input) { return !evidence.deviating.contains(input); };
    const auto derivations = all_derivations();
    return std::all_of(derivations.begin(), derivations.end(), [&](const Derivation& derivation) {
        return derivation.item != id || std::all_of(derivation.inputs.begin(), derivation.inputs.end(), is_right);
    });
}

bool may_be_negative(const ItemTargets& float_key) {
    const auto d = float_key.scalar(item::sphere::d);
    return d && d->lo() < 0;
}

/// The hits of correct programs, whose numbers are within `float_key`.
std::vector<HitValues> possible_hits(const ItemTargets& float_key, const IntervalScene& scene) {
    std::vector<HitValues> possible(1);
    for (HitValues& values : possible) {
        values.u = float_key.scalar(item::triangle::u);
        values.v = float_key.scalar(item::triangle::v);
    }
    for (const reference::Subject object : reference::objects) {
        const ItemId t{object, "t"};
        if (!float_key.targets().contains(t)) continue;
        std::vector<Target> ts;
        const bool tells_a_hit = reference::item_of(t).exists == reference::Exists::with_hit;
        if (tells_a_hit) ts = results_of(t, float_key, scene, QuadraticForm::full);
        if (const auto known = float_key.scalar(t)) ts.push_back(target_of(*known));
        if (ts.empty()) ts.push_back(no_value());
        std::vector<HitValues> more;
        for (const HitValues& values : possible) {
            for (const Target& target : ts) {
                more.push_back(values);
                more.back().t[object] = target.no_value ? std::nullopt : std::optional(target.components.front());
            }
        }
        possible = std::move(more);
    }
    return possible;
}

}  // namespace

bool is_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance) {
    const ItemId id = printed.spec.id;
    if (std::ranges::find(close_call_items(), id) == close_call_items().end()) return false;
    const auto may_be = [&](const ItemTargets& known, QuadraticForm form) {
        return is_one_of(printed, results_of(id, known, evidence.scene, form), evidence, allowance).has_value();
    };
    if (may_be(evidence.key, QuadraticForm::full)) return true;
    // A miss of the sphere does not have to follow from the printed discriminant: not every formula for t uses it.
    const bool is_miss = id == item::sphere::t && printed.value->numbers.empty();
    if (is_miss && std::any_of(evidence.float_keys.begin(), evidence.float_keys.end(), may_be_negative)) return true;
    if (!has_right_inputs(id, evidence)) return false;
    const bool possible = std::any_of(evidence.float_keys.begin(), evidence.float_keys.end(),
                                      [&](const ItemTargets& key) { return may_be(key, QuadraticForm::full); });
    return possible && may_be(with_own_values(evidence), evidence.quadratic_of(id.subject).form);
}

bool follows_from_close_call(const MatchedItem& printed, const Evidence& evidence, double allowance) {
    if (evidence.close_calls.empty()) return false;
    Evidence right_values = evidence;
    right_values.deviating = evidence.close_calls;
    for (auto& own : right_values.own)
        std::erase_if(own, [&](const auto& entry) { return !evidence.right.contains(entry.first); });
    return follows(printed, right_values, allowance).has_value();
}

std::vector<reference::FirstObject> close_first_objects(const Evidence& evidence) {
    std::vector<reference::FirstObject> objects;
    for (const ItemTargets& key : evidence.float_keys) {
        for (const HitValues& values : possible_hits(key, evidence.scene)) {
            const auto more = possible_first_objects(values, evidence.scene.boundaries);
            objects.insert(objects.end(), more.begin(), more.end());
        }
    }
    return objects;
}

}  // namespace harness
