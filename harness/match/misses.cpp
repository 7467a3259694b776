#include "harness/match/misses.h"

#include <algorithm>
#include <cmath>

namespace harness {
namespace {

bool is_none(const MatchedItem& item) {
    return item.value && item.value->numbers.empty();
}

/// Whether finite numbers are printed for the item, and not the zeros that a vector is set to before a hit is looked
/// for.
bool is_computed(const MatchedItem& item) {
    if (!item.value || is_none(item)) return false;
    const std::vector<PrintedNumber>& numbers = item.value->numbers;
    const bool is_unset = numbers.size() > 1 &&
                          std::ranges::all_of(numbers, [](const PrintedNumber& number) { return number.value == 0; });
    return !is_unset &&
           std::ranges::all_of(numbers, [](const PrintedNumber& number) { return std::isfinite(number.value); });
}

/// Whether the item is a t that programs print for "no hit", given what they print for the hit point and the normal.
bool stands_for_miss(const MatchedItem& item, const std::vector<const MatchedItem*>& others) {
    constexpr double farther_than_any_object = 1e9;
    if (item.spec.id.name != "t" || !item.value || item.value->numbers.size() != 1) return false;
    const double t = item.value->numbers.front().value;
    if (!is_of_hit(item.spec) ||
        std::ranges::any_of(others, [](const MatchedItem* other) { return is_computed(*other); }))
        return false;
    const bool is_denied = std::ranges::any_of(others, [](const MatchedItem* other) { return is_none(*other); });
    return t == -1 || t >= farther_than_any_object || (t == 0 && is_denied);
}

}  // namespace

void take_denials(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, Fits& fits) {
    for (MatchedItem& item : matched) {
        const bool has_number = item.value && fits(*item.value, item.spec) > LabelFit::foreign &&
                                std::ranges::any_of(item.value->numbers, [](const PrintedNumber& number) {
                                    return std::isfinite(number.value);
                                });
        if (has_number || is_none(item) || !is_of_hit(item.spec)) continue;
        const auto said = std::ranges::find_if(candidates, [&](const Candidate& candidate) {
            return candidate.value.numbers.empty() && !is_said_of_another(candidate.value, item.spec) &&
                   fits(candidate.value, item.spec) != LabelFit::forbidden;
        });
        if (said != candidates.end()) item.value = said->value;
    }
}

void settle_misses(std::vector<MatchedItem>& matched, const IsAnswered& is_answered) {
    const auto is_of_same_hit = [](const MatchedItem& item, const MatchedItem& other) {
        return is_of_hit(item.spec) && is_of_hit(other.spec) && item.spec.id.subject == other.spec.id.subject;
    };
    for (MatchedItem& t : matched) {
        std::vector<const MatchedItem*> others;
        for (const MatchedItem& other : matched) {
            if (other.spec.id != t.spec.id && is_of_same_hit(t, other)) others.push_back(&other);
        }
        if (stands_for_miss(t, others)) t.value->numbers.clear();
    }
    const std::vector<MatchedItem> before = matched;
    for (MatchedItem& item : matched) {
        if (is_none(item) || is_computed(item) || !is_answered(item.spec.question)) continue;
        const auto said = std::ranges::find_if(
            before, [&](const MatchedItem& other) { return is_none(other) && is_of_same_hit(item, other); });
        if (said == before.end()) continue;
        item.value = said->value;
        item.unreadable = false;
    }
}

}  // namespace harness
