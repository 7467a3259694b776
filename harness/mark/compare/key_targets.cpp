#include "harness/mark/compare/key_targets.h"

#include <algorithm>

#include "reference/key/graded_allowance.h"

namespace harness {
namespace {

using reference::Answer;
using reference::KeyItem;
using reference::PixelConvention;

/// The item's first answer with this convention; else its first answer, because an answer that several readings share
/// is listed once.
const Answer& answer_under(PixelConvention convention, const KeyItem& item) {
    const auto found = std::find_if(item.answers.begin(), item.answers.end(),
                                    [&](const Answer& answer) { return answer.reading.convention == convention; });
    return found == item.answers.end() ? item.answers.front() : *found;
}

}  // namespace

Target target_with_allowance(const KeyItem& item, const Answer& answer, const reference::Rubric& rubric) {
    Target target = target_of(answer);
    target.allowance = reference::graded_allowance(item, answer, rubric);
    return target;
}

std::vector<ItemTargets> keys_by_convention(const reference::AnswerKey& key, const reference::Rubric& rubric) {
    std::vector<ItemTargets> keys;
    for (const PixelConvention convention : rubric.pixel_conventions) {
        ItemTargets& known = keys.emplace_back();
        const auto set = [&](const KeyItem& item) {
            known.set(item.spec.id, target_with_allowance(item, answer_under(convention, item), rubric));
        };
        for (const reference::KeyQuestion& question : key.questions) std::ranges::for_each(question.items, set);
        std::ranges::for_each(key.not_asked, set);
    }
    return keys;
}

ItemTargets widened_by_allowance(const ItemTargets& key) {
    ItemTargets known;
    for (auto [id, target] : key.targets()) {
        for (std::size_t i = 0; i < target.allowance.size(); ++i) {
            const double allowance = target.allowance[i];
            if (allowance > 0) target.components[i] += Interval(-allowance, allowance);
        }
        target.allowance.clear();
        known.set(id, std::move(target));
    }
    return known;
}

}  // namespace harness
