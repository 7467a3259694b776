// Which object the ray hits first.
#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "harness/mark/diagnose/close_call.h"
#include "harness/mark/score/judge.h"

namespace harness {
namespace {

using reference::KeyItem;

/// The t of each kind of object in the scene.
std::vector<ItemId> hit_times(const Evidence& evidence) {
    std::vector<ItemId> times;
    for (const reference::Subject object : reference::objects) {
        if (evidence.key.targets().contains({object, "t"})) times.push_back({object, "t"});
    }
    return times;
}

/// Whether the student's own d, u or v says that the ray misses the object, so that t may be missing.
bool is_missed_by_own_values(reference::Subject object, const std::map<ItemId, Target>& own) {
    const auto value = [&](const ItemId& id) -> std::optional<Interval> {
        const auto found = own.find(id);
        if (found == own.end() || found->second.no_value) return std::nullopt;
        return found->second.components.front();
    };
    if (object != reference::Subject::triangle) {
        const auto d = value({object, "d"});
        return d && d->hi() < 0;
    }
    const auto u = value(item::triangle::u), v = value(item::triangle::v);
    return (u && u->hi() < 0) || (v && v->hi() < 0) || (u && v && (*u + *v).lo() > 1);
}

/// Whether the ray can't hit this object with these values.
bool is_missed(reference::FirstObject object, HitValues values, std::span<const reference::Boundary> boundaries) {
    std::erase_if(values.t, [&](const auto& each) { return reference::FirstObject(each.first) != object; });
    return !values.t.empty() && !std::ranges::count(possible_first_objects(values, boundaries), object);
}

}  // namespace

std::optional<HitValues> Judge::own_hits(const Evidence& evidence) const {
    const auto& own = evidence.own_values(Digits::as_printed);
    const auto value = [](const Target& target) {
        return target.no_value ? std::nullopt : std::optional(target.components.front());
    };
    HitValues hits;
    for (const ItemId& t : hit_times(evidence)) {
        const auto printed = own.find(t);
        if (printed == own.end() && reference::asked_item(key_, t) != nullptr) {
            if (!is_missed_by_own_values(t.subject, own)) return std::nullopt;
            hits.t[t.subject].reset();
            continue;
        }
        hits.t[t.subject] = value(printed == own.end() ? evidence.key.targets().at(t) : printed->second);
        if (hits.t[t.subject] && !hits.t[t.subject]->is_bounded()) return std::nullopt;
    }
    if (const auto u = own.find(item::triangle::u); u != own.end()) hits.u = value(u->second);
    if (const auto v = own.find(item::triangle::v); v != own.end()) hits.v = value(v->second);
    for (const reference::KeyQuestion& question : key_.questions) {
        for (const KeyItem& key_item : question.items) {
            const double allowance = allowance_of(key_item, rubric_);
            const std::string_view name = key_item.spec.id.name;
            if (name == "t") hits.t_allowance = std::max(hits.t_allowance, allowance);
            if (name == "u" || name == "v") hits.uv_allowance = std::max(hits.uv_allowance, allowance);
        }
    }
    return hits;
}

bool Judge::is_same_wrong_t(const Evidence& evidence) const {
    struct Printed {
        int objects = 0;
        bool wrong = false;
    };
    std::map<double, Printed> printed;
    for (const ItemId& t : hit_times(evidence)) {
        const MatchedItem* item = readable(matched_, t);
        if (item == nullptr || item->value->numbers.empty()) continue;
        const double value = item->value->numbers.front().value;
        if (std::isnan(value)) continue;
        Printed& with_this_t = printed[value];
        ++with_this_t.objects;
        with_this_t.wrong = with_this_t.wrong || !evidence.right.contains(t);
    }
    return std::ranges::any_of(printed, [&](const auto& each) {
        const auto& [t, with_this_t] = each;
        const auto nearest = printed.lower_bound(0.0);
        const bool another_is_nearer = nearest != printed.end() && nearest->first < t;
        return with_this_t.objects > 1 && with_this_t.wrong && !another_is_nearer;
    });
}

bool Judge::follows_wrong_miss(const PrintedFirstObject& printed, const Evidence& evidence) const {
    if (printed.object == reference::FirstObject::no_hit) return false;  // nothing was compared
    const auto is_called_missed = [&](const ItemId& id) {
        const MatchedItem* item = readable(matched_, id);
        return item != nullptr && item->value->numbers.empty() && !evidence.right.contains(id);
    };
    // The rubric decides whether t = 0 is a hit, so this is not a mistake.
    const auto is_in_front_or_missed = [&](const ItemId& t) {
        const MatchedItem* item = readable(matched_, t);
        return item == nullptr || item->value->numbers.empty() || item->value->numbers.front().value > 0;
    };
    Evidence believed = evidence;
    bool any_missed = false;
    for (const ItemId& t : hit_times(evidence)) {
        const bool is_missed = is_called_missed(t) || is_called_missed({t.subject, "hit"});
        if (!is_missed || !is_in_front_or_missed(t)) continue;
        any_missed = true;
        for (auto& own : believed.own) own[t] = no_value();
    }
    if (!any_missed) return false;
    const std::optional<HitValues> hits = own_hits(believed);
    if (!hits) return false;
    const auto possible = possible_first_objects(*hits, evidence.scene.boundaries);
    return std::ranges::find(possible, printed.object) != possible.end();
}

ItemVerdict Judge::judge_first_object(const KeyItem& item, const PrintedFirstObject& printed, const Evidence& evidence,
                                      ItemScore& score) const {
    const auto contains = [&](const std::vector<reference::FirstObject>& objects) {
        return std::find(objects.begin(), objects.end(), printed.object) != objects.end();
    };
    const std::optional<HitValues> hits = own_hits(evidence);
    const bool agrees_with_own = hits && contains(possible_first_objects(*hits, evidence.scene.boundaries));
    const bool follows_own = hits && (agrees_with_own || printed.object == smaller_t(*hits));
    const auto answer = std::find_if(item.answers.begin(), item.answers.end(), [&](const reference::Answer& a) {
        return a.value == reference::Value(printed.object);
    });
    // If the rubric accepts two objects, the student's answer is right if it follows from the student's own values.
    if (answer != item.answers.end() && (item.answers.size() == 1 || !hits || follows_own)) {
        score.accepted_as = reference::reason(*answer, key_);
        return ItemVerdict::right;
    }
    if (agrees_with_own && contains(close_first_objects(evidence))) {
        score.accepted_as = "rounding may decide which object is hit first";
        return ItemVerdict::right;
    }
    std::vector<ItemId> deciding = hit_times(evidence);
    deciding.insert(deciding.end(), {item::triangle::u, item::triangle::v, item::sphere::d, item::cylinder::d});
    const bool own_deviates =
        std::ranges::any_of(deciding, [&](const ItemId& id) { return evidence.deviating.contains(id); });
    if (follows_own && own_deviates && !is_same_wrong_t(evidence)) return ItemVerdict::follow;
    if (!follows_own && follows_wrong_miss(printed, evidence)) return ItemVerdict::follow;
    if (follows_own && !agrees_with_own) {
        score.diagnosis = "hit not tested";
        score.advice =
            "That object has the smaller t, but according to your own values the ray does not hit it: test whether u "
            "and v are inside the triangle and whether t is positive.";
        if (own_deviates) score.advice += made_visible;
    }
    if (hits && !follows_own) {
        score.diagnosis = "verdict against own values";
        score.advice = is_missed(printed.object, *hits, evidence.scene.boundaries)
                           ? "According to your own values, the ray does not hit that object; test this before you "
                             "compare t."
                           : "This does not agree with the values of t that you printed for the objects; compare them "
                             "again.";
        if (own_deviates) score.advice += made_visible;
    }
    return ItemVerdict::wrong;
}

}  // namespace harness
