#include "harness/stress/losses.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/methods/sphere_methods.h"
#include "reference/stages/scene_numbers.h"

namespace harness::stress {
namespace {

using reference::KeyItem;

/// The number of right digits, at most float's; 0 if there is nothing to count.
int digits(double scale, double error) {
    if (!(scale > 0) || !std::isfinite(error)) return 0;
    const double count = error > 0 ? std::log10(scale / error) : FLT_DIG;
    return static_cast<int>(std::clamp(std::floor(count), 0.0, double{FLT_DIG}));
}

/// The magnitude from which the digits of an item count: its largest component, or 1, the whole edge, for u and v.
double scale_of(const KeyItem& item) {
    if (item.spec.id.name == "u" || item.spec.id.name == "v") return 1;
    const auto* numbers = std::get_if<reference::Numbers>(&item.answers.front().value);
    return numbers == nullptr ? 0 : reference::largest_component(*numbers);
}

bool is_none(const reference::Answer& answer) {
    return std::holds_alternative<reference::NoValue>(answer.value);
}

const ItemScore* find(const Score& score, const reference::ItemSpec& spec) {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.spec.id == spec.id) return &item;
        }
    }
    return nullptr;
}

/// Whether the verdict was accepted although it is not the key's.
bool is_forgiven(const ItemScore& item, const KeyItem& key_item, const reference::AnswerKey& key) {
    return std::none_of(key_item.answers.begin(), key_item.answers.end(), [&](const reference::Answer& answer) {
        return reference::reason(answer, key) == item.accepted_as;
    });
}

/// The loss if the program confused hit and miss. This is only clear if all answers of the key have a value, or none
/// has.
std::optional<Loss> wrong_decision(const ItemScore& item, const KeyItem& key_item) {
    const auto& answers = key_item.answers;
    if (item.no_value && std::none_of(answers.begin(), answers.end(), is_none)) return Loss::hit_missed;
    if (!item.no_value && std::all_of(answers.begin(), answers.end(), is_none)) return Loss::miss_hit;
    return {};
}

void count_digits(HardItem& lost, const ItemScore& item, const KeyItem& key_item) {
    if (!item.error) return;
    const double scale = scale_of(key_item);
    lost.digits_printed = digits(scale, 2 * item.half_unit);
    lost.digits_kept = std::min(lost.digits_printed, digits(scale, *item.error));
}

/// The loss of an item; empty if nothing is lost.
std::optional<HardItem> loss_of(const ItemScore& item, const KeyItem& key_item, const reference::AnswerKey& key) {
    constexpr int of_rounding = 1;  // rounding may cost one digit in any scene
    HardItem lost{key_item.spec.question, std::string(key_item.spec.name), Loss::wrong, 0, 0, item.diagnosis};
    const bool right = item.verdict == ItemVerdict::right;
    if (item.verdict == ItemVerdict::follow) return {};
    if (item.printed.empty() || item.verdict == ItemVerdict::unreadable) {
        lost.loss = Loss::missing;
        return lost;
    }
    if (key_item.spec.shape == reference::Shape::first_object) {
        lost.loss = Loss::other_first;
        return right && !is_forgiven(item, key_item, key) ? std::nullopt : std::optional(lost);
    }
    if (item.not_finite) {
        lost.loss = Loss::not_a_number;
        return lost;
    }
    if (const auto decision = wrong_decision(item, key_item)) {
        lost.loss = *decision;
        return lost;
    }
    count_digits(lost, item, key_item);
    if (!right && item.diagnosis != "too few decimals") return lost;
    lost.loss = Loss::digits;
    return lost.digits_printed - lost.digits_kept > of_rounding ? std::optional(lost) : std::nullopt;
}

/// The subject of the key's item.
reference::Subject subject_of(const HardItem& lost, const reference::AnswerKey& key) {
    for (const reference::KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (question.number == lost.question && item.spec.name == lost.item) return item.spec.id.subject;
        }
    }
    throw std::logic_error("a lost item that the key does not have");
}

/// Whether the handout's formulas keep 5 of float's 6 digits in this item.
bool keeps_digits(const reference::accuracy::ItemAccuracy& item, std::string_view scalar) {
    constexpr double five_digits = 84;  // units in the last place of float, each at least 1.2e-7 of the value
    const auto error = std::ranges::find(item.errors, scalar, &reference::accuracy::ItemError::scalar);
    return !error->otherwise && error->ulp <= five_digits;
}

/// Whether the stable root in float gives the sphere's t to 5 digits.
bool keeps_t_by_the_stable_root(const Marking& marking) {
    const auto scene = reference::convert_scene<float>(
        marking.assignment.scene, [](const reference::Decimal& x) { return static_cast<float>(x.to_double()); });
    const auto ray = reference::answer_camera(scene, marking.key.canonical.convention);
    const auto found =
        reference::accuracy::stable(reference::accuracy::Ray<float>{ray.P_WCS, ray.V}, scene.spheres.front());
    const KeyItem* const t = reference::asked_item(marking.key, reference::item::sphere::t);
    const auto* truth = t == nullptr ? nullptr : std::get_if<reference::Numbers>(&t->answers.front().value);
    if (truth == nullptr) return false;
    return found.hit && std::abs(static_cast<double>(found.t) - truth->front()) <= 1e-5 * std::abs(truth->front());
}

}  // namespace

std::vector<HardItem> losses(const Score& base, const Score& score, const Marking& marking) {
    std::vector<HardItem> lost;
    for (const reference::KeyQuestion& question : marking.key.questions) {
        for (const KeyItem& key_item : question.items) {
            const ItemScore* before = find(base, key_item.spec);
            const ItemScore* after = find(score, key_item.spec);
            const bool was_right =
                before != nullptr && before->verdict == ItemVerdict::right && !before->printed.empty();
            if (!was_right || after == nullptr) continue;
            if (auto item = loss_of(*after, key_item, marking.key)) lost.push_back(std::move(*item));
        }
    }
    return lost;
}

std::vector<HardItem> that_count(std::vector<HardItem> lost, std::optional<reference::Subject> about,
                                 const reference::AnswerKey& key) {
    using reference::Subject;
    const bool other_lost = std::ranges::any_of(lost, [&](const HardItem& item) {
        const Subject subject = subject_of(item, key);
        return subject != about && subject != Subject::camera && subject != Subject::first_hit;
    });
    std::erase_if(lost, [&](const HardItem& item) {
        const Subject subject = subject_of(item, key);
        if (subject == Subject::first_hit) return !about || other_lost;
        return about && subject != about;
    });
    return lost;
}

std::string advice(const std::vector<HardItem>& lost, const Marking& marking) {
    if (lost.empty()) return "";
    bool float_keeps = true, double_keeps = true, is_about_t = true;
    for (const auto& item : reference::accuracy::item_accuracies(marking.assignment, marking.key)) {
        const auto is_this = [&](const HardItem& one) {
            return one.question == item.spec.question && one.item == item.spec.name;
        };
        if (std::ranges::none_of(lost, is_this)) continue;
        float_keeps = float_keeps && keeps_digits(item, "float");
        double_keeps = double_keeps && keeps_digits(item, "double");
        const reference::ItemId& id = item.spec.id;
        is_about_t = is_about_t && (id == reference::item::sphere::t || id == reference::item::sphere::hit ||
                                    id == reference::item::sphere::normal);
    }
    if (float_keeps) return "Not a rounding error: the handout's formulas work.";
    if (is_about_t && keeps_t_by_the_stable_root(marking)) return "Use the stable root, t = c / q.";
    return double_keeps ? "Use double." : "Double is wrong too: decide exactly.";
}

reference::PixelConvention own_convention(const Score& base, const reference::AnswerKey& key) {
    for (const reference::KeyQuestion& question : key.questions) {
        for (const KeyItem& key_item : question.items) {
            const ItemScore* item = find(base, key_item.spec);
            if (item == nullptr || item->verdict != ItemVerdict::right || item->accepted_as.empty()) continue;
            for (const reference::Answer& answer : key_item.answers) {
                const bool another = answer.reading.convention != key.canonical.convention;
                if (another && reference::reason(answer, key) == item->accepted_as) return answer.reading.convention;
            }
        }
    }
    return key.canonical.convention;
}

}  // namespace harness::stress
