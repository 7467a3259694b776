#include "harness/match/misses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace harness {
namespace {

using reference::ItemSpec;

bool is_none(const MatchedItem& item) {
    return item.value && item.value->numbers.empty();
}

bool all_are(const MatchedItem& item, const auto& is) {
    return item.value && std::ranges::all_of(item.value->numbers, [&](const PrintedNumber& x) { return is(x.value); });
}

/// The items that "no hit" says not to be there, of one object.
std::vector<MatchedItem*> items_of_hit(std::vector<MatchedItem>& matched, reference::Subject object) {
    std::vector<MatchedItem*> items;
    for (MatchedItem& item : matched) {
        if (item.spec.id.subject == object && is_of_hit(item.spec)) items.push_back(&item);
    }
    return items;
}

/// The words that say that the item has no value; candidates.end() if there are none.
std::vector<Candidate>::const_iterator said_not_to_be(const std::vector<Candidate>& candidates, const ItemSpec& item,
                                                      Fits& fits) {
    return std::ranges::find_if(candidates, [&](const Candidate& candidate) {
        return candidate.value.numbers.empty() && !is_said_of_another(candidate.value, item) &&
               fits(candidate.value, item) != LabelFit::forbidden;
    });
}

/// The printed t of an object's hit, if it is one number.
std::optional<double> t_of_hit(const MatchedItem& item) {
    if (item.spec.id.name != "t" || !is_of_hit(item.spec) || !item.value || item.value->numbers.size() != 1) return {};
    return item.value->numbers.front().value;
}

/// "t = -1", "t = inf" or "t = 1e30" says that there is no hit if no finite number is printed for the hit point and the
/// normal beside it. So does "t = 0" if they are said not to be there.
void read_stand_in(std::vector<MatchedItem>& matched) {
    constexpr double farther_than_any_object = 1e9;
    for (MatchedItem& item : matched) {
        const auto t = t_of_hit(item);
        if (!t) continue;
        std::ptrdiff_t others = 0, finite = 0, absent = 0;
        for (const MatchedItem* other : items_of_hit(matched, item.spec.id.subject)) {
            if (other == &item) continue;
            ++others;
            absent += is_none(*other) ? 1 : 0;
            finite +=
                other->value && !is_none(*other) && all_are(*other, [](double x) { return std::isfinite(x); }) ? 1 : 0;
        }
        const bool stands_in = (*t == -1 || *t >= farther_than_any_object) && finite == 0;
        if (others > 0 && (stands_in || (*t == 0 && absent == others))) item.value->numbers.clear();
    }
}

/// "The ray misses the sphere", said once, holds for t, the hit point and the normal alike, also where nan, inf or a
/// number that is named otherwise stands for them.
void share_no_value(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, Fits& fits) {
    const std::vector<MatchedItem> before = matched;
    for (MatchedItem& item : matched) {
        const bool has_number = item.value && !all_are(item, [](double x) { return !std::isfinite(x); }) &&
                                fits(*item.value, item.spec) > LabelFit::foreign;
        if (has_number || is_none(item) || !is_of_hit(item.spec)) continue;
        const auto beside = std::find_if(before.begin(), before.end(), [&](const MatchedItem& other) {
            return is_none(other) && other.spec.id.subject == item.spec.id.subject;
        });
        const auto said = said_not_to_be(candidates, item.spec, fits);
        if (beside != before.end()) {
            item.value = beside->value;
        } else if (said != candidates.end()) {
            item.value = said->value;
        }
    }
}

/// The same for the items of other questions: a sphere that the ray misses has no normal in question 7. The items of a
/// question that was not answered are left out.
void share_no_value_between(std::vector<MatchedItem>& matched, const IsAnswered& is_answered) {
    const std::vector<MatchedItem> before = matched;
    for (MatchedItem& item : matched) {
        const bool has_number = item.value && !all_are(item, [](double x) { return !std::isfinite(x); });
        if (!is_answered(item.spec.question) || has_number || is_none(item) || !is_of_hit(item.spec)) continue;
        const auto said = std::ranges::find_if(before, [&](const MatchedItem& other) {
            return is_none(other) && other.spec.id.subject == item.spec.id.subject && is_of_hit(other.spec);
        });
        if (said == before.end()) continue;
        item.value = said->value;
        item.unreadable = false;
    }
}

}  // namespace

void settle_misses(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, Fits& fits) {
    share_no_value(matched, candidates, fits);
    read_stand_in(matched);
    share_no_value(matched, candidates, fits);
}

void settle_misses_between_questions(std::vector<MatchedItem>& matched, const IsAnswered& is_answered) {
    share_no_value_between(matched, is_answered);
}

}  // namespace harness
