// What an instructor is told on stderr about a class beside its marks.
#pragma once

#include <string>
#include <vector>

#include "harness/grade/own_scene_score.h"
#include "harness/gradebook/gradebook.h"
#include "harness/report/exchange/late_days.h"

namespace harness {

/// Files of the class that can't be hand-ins.
void tell_left_out(const std::vector<std::string>& files);

/// The notes of the submissions. One that every submission has is printed once.
void tell_notes(const std::vector<Graded>& graded);

/// Whose answers are right for a scene that was dealt to somebody else.
void tell_answers_of_others(const std::vector<AnswersOfAnother>& found);

/// Students whom a scene was dealt to and who handed nothing in.
void tell_not_handed_in(const Marking& marking, const std::vector<Graded>& graded);

/// Rows of --late-days that name no submission, because they may be misspelt, and that days cost nothing by the rubric.
void tell_late_days(const report::LateDays& days, const reference::Rubric& rubric, const std::vector<Graded>& graded);

/// Overrides of submissions or items that are not in the class.
void tell_unmatched(const std::vector<KeptOverride>& overrides);

/// Overrides that give more than their place is worth, perhaps because the rubric has changed.
void tell_overrides_above_most(const std::vector<Graded>& graded);

/// That who is gone from the class goes from its results too, and how one hand-in is added.
void tell_that_apply_takes_out(const ClassChanges& changes);

/// Rereads that do not count, and why.
void tell_that_count_not(const std::vector<KeptReread>& rereads, const std::vector<Graded>& graded);

}  // namespace harness
