// How an assignment is marked.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/stages/camera.h"
#include "reference/stages/items.h"
#include "reference/toml/moment.h"

namespace reference {

/// How a hit at exactly t = 0 counts in marking. `either` accepts both a hit and a miss, if the answers are consistent.
enum class BoundaryPolicy { positive, nonnegative, either };

/// The deduction for a hand-in that is this many days late or more.
struct LateStep {
    int days;      ///< started days, 1 or more
    double share;  ///< of the submission's points, 0 to 1
};

/// The credit for a named mistake. The code that names mistakes checks the names.
struct MistakePrice {
    std::string name;                 ///< "center forgotten", in American spelling even if the file's differs
    double share;                     ///< of the item's points, 0 to 1; 1 accepts the answer
    std::string place;                ///< for messages: file, line and key
    std::optional<ItemId> item = {};  ///< the only item with this credit; empty for every item
};

/// How much feedback a student gets about an answer that is not right; each level includes the ones before it.
enum class Feedback {
    verdict,   ///< the verdict and the points
    hint,      ///< a description of the value itself: not a number, of another shape, follows or does not
    mistake,   ///< the known mistake that gives this value
    expected,  ///< the right value
};

/// How the assignment is marked. Every field is an optional key of [rubric] with the default given here.
struct Rubric {
    /// Where in its pixel a ray may start. The first makes the key, the others are also accepted.
    std::vector<PixelConvention> pixel_conventions = {PixelConvention::centre, PixelConvention::grid};
    BoundaryPolicy boundary = BoundaryPolicy::either;
    /// Credit for an answer that follows from an earlier mistake, as a share of its points, 0 to 1.
    double follow_through = 1.0;
    /// Same for an answer that is right for the scene that the student's source states instead of the assignment's.
    double wrong_scene_credit = 0.5;
    /// The maximum that all such answers of a submission may earn together, as a share of its points, 0 to 1. Beyond it
    /// each of them earns proportionally less.
    double follow_through_cap = 1.0;
    /// Deductions for late hand-ins, by days; the file's `late_deduction` is one step for every late hand-in.
    std::vector<LateStep> late;
    /// When the assignment is due, for hand-ins whose time is known.
    std::optional<Moment> due;
    /// This much later is still on time.
    int grace_minutes = 0;
    /// Points for answers on other scenes (`grade --variants`), in addition to the questions' points; 0 for none.
    double variant_points = 0;
    /// The feedback about an answer until the assignment is due; see feedback_at.
    Feedback feedback = Feedback::mistake;
    /// The feedback from then on; empty for the same. Only with `due`.
    std::optional<Feedback> feedback_after_due;
    /// An answer may be off by half a unit of its last printed decimal. An answer with fewer decimals than this counts
    /// as if it had this many. 0 to 9.
    int min_decimals = 2;
    /// In the order of their names. A mistake that is not listed earns nothing.
    std::vector<MistakePrice> mistakes;
    /// Points of a question by its number; questions that are not listed have points_per_question.
    std::map<int, double> points;
    /// Points of single items, by question and item name; without them the question's points are shared equally.
    std::map<int, std::map<std::string, double>> item_points;
    static constexpr double points_per_question = 10.0;

    /// How far an answer may be from the key, in the item's own unit, and relative to the item's largest component if
    /// that is above 1: |given - key| <= tolerance * max(1, |key|). It widens the key's allowance and may not be
    /// narrower; without a tolerance only the allowance counts.
    std::optional<double> tolerance;
    /// Same for a question or a single item: "6" or "6.t".
    std::map<std::string, double> item_tolerance;

    double points_of(int question) const;
    /// The most specific tolerance given: the item's, else the question's, else `tolerance`; empty for none.
    std::optional<double> tolerance_of(int question, const std::string& item) const;
};

/// "verdict"
std::string_view to_string(Feedback feedback);

/// The feedback that students get at this time. Within the grace minutes a hand-in is still on time, so
/// `feedback_after_due` begins after them.
Feedback feedback_at(const Rubric& rubric, std::chrono::system_clock::time_point clock);

/// The largest size of a component.
double largest_component(const std::vector<double>& key_value);

/// The unit of a relative tolerance: the largest component of the key's value, or 1 if that is below 1.
double unit_of(const std::vector<double>& key_value);

}  // namespace reference
