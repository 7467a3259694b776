#include "harness/record/final_mark.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/record/override_place.h"
#include "harness/text/points.h"

namespace harness {
namespace {

/// Whether an override replaces part of the submission, so that the automatic sum is no longer valid.
bool any_within(const Graded& graded) {
    return std::any_of(graded.review.overrides.begin(), graded.review.overrides.end(),
                       [](const Override& by_hand) { return by_hand.question != 0 || !by_hand.item.empty(); });
}

/// The points before the late deduction. Returns the automatic sum if no override replaces part of it, because summing
/// again could round differently.
double before_late(const Graded& graded) {
    if (!any_within(graded)) return graded.score.points;
    double sum = final_scenes_points(graded);
    for (const QuestionScore& question : graded.score.questions) sum += final_points(graded, question);
    return sum;
}

/// The points that count at the place of an override; empty if the place has no points yet.
std::optional<double> final_points_at(const Graded& graded, const Override& given) {
    if (given.question == 0)
        return given.item.empty() ? points_that_count(graded) : std::optional(final_scenes_points(graded));
    for (const QuestionScore& question : graded.score.questions) {
        if (question.number != given.question) continue;
        if (given.item.empty()) return final_points(graded, question);
        for (const ItemScore& item : question.items) {
            if (item.spec.name == given.item) return final_points(graded, question, item);
        }
    }
    return std::nullopt;
}

}  // namespace

const Override* find_override(const Graded& graded, int question, const std::string& item) {
    const auto found =
        std::find_if(graded.review.overrides.rbegin(), graded.review.overrides.rend(),
                     [&](const Override& by_hand) { return by_hand.question == question && by_hand.item == item; });
    return found == graded.review.overrides.rend() ? nullptr : &*found;
}

double final_points(const Graded& graded, const QuestionScore& question, const ItemScore& item) {
    const Override* whole = question.items.size() == 1 ? find_override(graded, question.number, "") : nullptr;
    const Override* own = whole ? whole : find_override(graded, question.number, std::string(item.spec.name));
    return own == nullptr ? item.points : own->points;
}

double final_points(const Graded& graded, const QuestionScore& question) {
    if (const Override* own = find_override(graded, question.number, "")) return own->points;
    const bool untouched = std::none_of(graded.review.overrides.begin(), graded.review.overrides.end(),
                                        [&](const Override& by_hand) { return by_hand.question == question.number; });
    if (untouched) return question.points;
    double sum = 0;
    for (const ItemScore& item : question.items) sum += final_points(graded, question, item);
    return sum;
}

double final_scenes_points(const Graded& graded) {
    if (!graded.score.variants) return 0;
    const Override* own = find_override(graded, 0, std::string(variants_place));
    return own == nullptr ? graded.score.variants->points : own->points;
}

std::optional<FinalMark> final_mark(const Graded& graded) {
    if (const Override* whole = find_override(graded, 0, "")) return FinalMark{whole->points, 0};
    if (graded.execution.outcome == Outcome::not_graded) return std::nullopt;
    const double points = before_late(graded);
    const double deduction = points * graded.late_share;
    return FinalMark{points - deduction, deduction};
}

std::optional<double> points_that_count(const Graded& graded) {
    const auto mark = final_mark(graded);
    return mark ? std::optional(mark->points) : std::nullopt;
}

std::string lowered_by(const Graded& before, const Override& given) {
    Graded after = before;
    after.review.overrides.push_back(given);
    const auto drop = [](const std::string& what, const std::optional<double>& from, const std::optional<double>& to) {
        const bool falls = from && to && *to < *from;
        return falls ? fmt::format("{} from {} to {}", what, points_text(*from), points_text(*to)) : "";
    };
    const bool is_whole = given.question == 0 && given.item.empty();
    const std::string place =
        is_whole ? "" : drop(place_in_words(place_of(given)), final_points_at(before, given), given.points);
    const std::string mark = drop("the mark", points_that_count(before), points_that_count(after));
    if (place.empty()) return mark;
    return mark.empty() ? place + " points" : place + " points, and " + mark;
}

}  // namespace harness
