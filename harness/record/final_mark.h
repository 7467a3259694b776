// The final mark: the automatic marks, replaced by the instructor's overrides, less the deduction for a late
// submission. Every report takes its points from here.
#pragma once

#include <optional>
#include <string>

#include "harness/record/graded.h"

namespace harness {

/// Finds the last override of exactly this item, question (`item` empty), submission (`question` 0, `item` empty) or
/// points for other scenes (`question` 0, `item` variants_place). Null if there is none.
const Override* find_override(const Graded& graded, int question, const std::string& item);

/// The points of an item: from its own override, or from its question's if the question has only this item; else the
/// automatic points.
double final_points(const Graded& graded, const QuestionScore& question, const ItemScore& item);

/// Points of a question: those of its override, else the sum of its items' final points.
double final_points(const Graded& graded, const QuestionScore& question);

/// Points for answers on other scenes: those of an override, else the automatic points; 0 if the rubric gives none.
double final_scenes_points(const Graded& graded);

struct FinalMark {
    double points = 0;
    double late_deduction = 0;  ///< in points; already subtracted from `points`
};

/// The final mark of a submission. An override of the whole submission counts without a late deduction. Otherwise the
/// mark is the sum of the questions and other scenes, less the rubric's share for a late submission. Empty if the
/// submission was not graded and has no override of the whole.
std::optional<FinalMark> final_mark(const Graded& graded);

/// The points of final_mark().
std::optional<double> points_that_count(const Graded& graded);

/// Says what an override lowers: "question 6 from 8.33 to 2 points, and the mark from 98.33 to 92". Empty if it lowers
/// nothing or if the submission has no such place.
std::string lowered_by(const Graded& before, const Override& given);

}  // namespace harness
