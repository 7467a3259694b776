#include "harness/experiment/identify/claims.h"

#include <algorithm>
#include <string>
#include <utility>

#include "harness/mark/compare/key_targets.h"
#include "harness/mark/diagnose/derivations.h"
#include "harness/mark/score/mark_transcript.h"

namespace harness::experiment {

using reference::ItemId;
using reference::ItemSpec;

void Claims::add(const ItemSpec& item, Candidate candidate, Evidence evidence) {
    for (const std::size_t slot : candidate.slots) used_[slot] = true;
    claims_[item.id] = {std::move(candidate), evidence};
}

const Claim* Claims::of(const ItemId& id) const {
    const auto found = claims_.find(id);
    return found == claims_.end() ? nullptr : &found->second;
}

bool Claims::is_used(const std::vector<std::size_t>& slots) const {
    return std::ranges::any_of(slots, [&](std::size_t slot) { return used_[slot]; });
}

bool Claims::moves(const Candidate& candidate) const {
    return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return slots_[slot].moves(); });
}

MatchedItem Claims::on_scene(std::size_t scene, const ItemSpec& item, const Candidate& candidate) const {
    MatchedItem matched{item, PrintedValue(), candidate.order, {}, false, {}};
    for (const std::size_t slot : candidate.slots) {
        const NumberOfLine& on_scene = slots_[slot].numbers[scene];
        matched.value->numbers.push_back(on_scene.number);
        if (candidate.is_negated(on_scene)) matched.value->numbers.back().value = -on_scene.number.value;
        matched.value->line = slots_[slot].place.line;
    }
    matched.value->last_line = matched.value->line;
    return matched;
}

std::vector<MatchedItem> Claims::all_on_scene(std::size_t scene) const {
    std::vector<MatchedItem> matched;
    for (const ItemSpec& item : items_) {
        if (const Claim* claim = of(item.id)) matched.push_back(on_scene(scene, item, claim->candidate));
    }
    return matched;
}

bool Claims::is_right(std::size_t scene, const ItemSpec& item, const Candidate& candidate) {
    const Observation& other = others_[scene];
    std::vector<Target>& targets = targets_[scene][item.id];
    if (targets.empty()) {
        const reference::KeyItem& key = *reference::asked_item(other.key, item.id);
        for (const reference::Answer& answer : key.answers)
            targets.push_back(target_with_allowance(key, answer, other.assignment.rubric));
    }
    const MatchedItem printed = on_scene(scene, item, candidate);
    return std::ranges::any_of(targets, [&](const Target& target) {
        return !target.no_value && compare(printed, target, 0, other.assignment.rubric.min_decimals).within;
    });
}

bool Claims::is_right(const ItemSpec& item, const Candidate& candidate) {
    for (std::size_t scene = 0; scene < others_.size(); ++scene) {
        if (!is_right(scene, item, candidate)) return false;
    }
    return true;
}

std::optional<Evidence> Claims::evidence_of(const ItemSpec& item, const Candidate& candidate) const {
    std::optional<ItemScore> first;
    for (std::size_t scene = 0; scene < others_.size(); ++scene) {
        std::vector<MatchedItem> matched = all_on_scene(scene);
        matched.push_back(on_scene(scene, item, candidate));
        const Score score = mark_answers(matched, others_[scene].key, others_[scene].assignment);
        std::optional<ItemScore> there;
        for_each_item(score, [&](const ItemScore& scored) {
            if (scored.spec.id == item.id) there = scored;
        });
        const bool is_something = there && (there->verdict == ItemVerdict::right ||
                                            there->verdict == ItemVerdict::follow || !there->diagnosis.empty());
        if (!is_something || there->diagnosis == "too few decimals") return std::nullopt;
        if (first && (first->verdict != there->verdict || first->diagnosis != there->diagnosis)) return std::nullopt;
        first = std::move(there);
    }
    if (!first) return std::nullopt;
    if (first->verdict == ItemVerdict::right) return Evidence::right;
    return first->verdict == ItemVerdict::follow ? Evidence::follows : Evidence::named_mistake;
}

std::vector<MistakeOnScenes> Claims::mistakes() const {
    std::map<ItemId, MistakeOnScenes> wrong;
    for (std::size_t scene = 0; scene < others_.size(); ++scene) {
        const Score score = mark_answers(all_on_scene(scene), others_[scene].key, others_[scene].assignment);
        for_each_item(score, [&](const ItemScore& item) {
            const ItemId& id = item.spec.id;
            if (!claims_.contains(id) || (scene > 0 && !wrong.contains(id))) return;
            if (item.verdict != ItemVerdict::wrong) {
                wrong.erase(id);
            } else if (scene == 0) {
                wrong[id] = {item.spec.question, std::string(item.spec.name), item.diagnosis, item.advice};
            } else if (wrong[id].diagnosis != item.diagnosis) {
                wrong[id].diagnosis.clear();
                wrong[id].advice.clear();
            }
        });
    }
    std::vector<MistakeOnScenes> mistakes;
    for (auto& [id, mistake] : wrong) mistakes.push_back(std::move(mistake));
    return mistakes;
}

bool depends_on(const ItemId& id, const std::set<ItemId>& inputs) {
    if (id == reference::item::first_object) {
        return std::ranges::any_of(inputs,
                                   [](const ItemId& input) { return input.subject != reference::Subject::camera; });
    }
    return std::ranges::any_of(all_derivations(), [&](const Derivation& derivation) {
        return derivation.item == id &&
               std::ranges::any_of(derivation.inputs, [&](const ItemId& input) { return inputs.contains(input); });
    });
}

}  // namespace harness::experiment
