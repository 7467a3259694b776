// What counts in the end: the automatic marks, the instructor's overrides in their place, less what a late hand-in
// loses. Every report that names points takes them from here.
#pragma once

#include <optional>

#include "harness/grade.h"

namespace harness {

/// The override of just this item, question (`item` empty), submission (`question` 0, `item` empty) or what there is
/// for other scenes (`question` 0, `item` other_scenes_place); the last one counts. Null when there is none.
const Override* find_override(const Graded& graded, int question, const std::string& item);

/// Points of an item: its override's, else the automatic ones.
double final_points(const Graded& graded, const QuestionScore& question, const ItemScore& item);

/// Points of a question: its own override's, else the sum of its items'.
double final_points(const Graded& graded, const QuestionScore& question);

/// Points for answers on other scenes: an override's, else the automatic ones; 0 where the rubric gives none for them.
double final_scenes_points(const Graded& graded);

struct FinalMark {
    double points = 0;
    double late_deduction = 0;  ///< in points, taken off already
};

/// Points of a submission: an override of the whole stands as it is; else the sum of its questions and other scenes,
/// less the rubric's share for a late hand-in. Empty when it was not graded and the instructor has not given it points
/// as a whole.
std::optional<FinalMark> final_mark(const Graded& graded);

/// Its points alone.
std::optional<double> points_that_count(const Graded& graded);

}  // namespace harness
