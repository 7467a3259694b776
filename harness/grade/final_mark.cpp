#include "harness/grade/final_mark.h"

#include <algorithm>

namespace harness {
namespace {

/// Whether an override replaces part of the submission, so that the automatic sum no longer holds.
bool any_within(const Graded& graded) {
    return std::any_of(graded.overrides.begin(), graded.overrides.end(),
                       [](const Override& each) { return each.question != 0 || !each.item.empty(); });
}

/// The points before the late deduction. Returns the automatic sum if no override replaces part of it, because summing
/// again could round differently.
double before_late(const Graded& graded) {
    if (!any_within(graded)) return graded.score.points;
    double sum = final_scenes_points(graded);
    for (const QuestionScore& question : graded.score.questions) sum += final_points(graded, question);
    return sum;
}

}  // namespace

const Override* find_override(const Graded& graded, int question, const std::string& item) {
    const auto found = std::find_if(graded.overrides.rbegin(), graded.overrides.rend(), [&](const Override& each) {
        return each.question == question && each.item == item;
    });
    return found == graded.overrides.rend() ? nullptr : &*found;
}

double final_points(const Graded& graded, const QuestionScore& question, const ItemScore& item) {
    const Override* own = find_override(graded, question.number, std::string(item.spec.name));
    return own == nullptr ? item.points : own->points;
}

double final_points(const Graded& graded, const QuestionScore& question) {
    if (const Override* own = find_override(graded, question.number, "")) return own->points;
    const bool untouched = std::none_of(graded.overrides.begin(), graded.overrides.end(),
                                        [&](const Override& each) { return each.question == question.number; });
    if (untouched) return question.points;
    double sum = 0;
    for (const ItemScore& item : question.items) sum += final_points(graded, question, item);
    return sum;
}

double final_scenes_points(const Graded& graded) {
    if (!graded.score.other_scenes) return 0;
    const Override* own = find_override(graded, 0, std::string(other_scenes_place));
    return own == nullptr ? graded.score.other_scenes->points : own->points;
}

std::optional<FinalMark> final_mark(const Graded& graded) {
    if (const Override* whole = find_override(graded, 0, "")) return FinalMark{whole->points, 0};
    if (graded.outcome == Outcome::not_graded) return std::nullopt;
    const double points = before_late(graded);
    const double deduction = points * graded.late_share;
    return FinalMark{points - deduction, deduction};
}

std::optional<double> points_that_count(const Graded& graded) {
    const auto mark = final_mark(graded);
    return mark ? std::optional(mark->points) : std::nullopt;
}

}  // namespace harness
