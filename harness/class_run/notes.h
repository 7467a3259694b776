// Notes to the instructor on stderr about a class, besides its marks.
#pragma once

#include <string>
#include <vector>

#include "harness/grade/own_scene_score.h"
#include "harness/gradebook/gradebook.h"
#include "harness/report/exchange/late_days.h"

namespace harness {

/// Reports files of the class that can't be hand-ins.
void tell_left_out(const std::vector<std::string>& files);

/// Prints the notes of the submissions. A note that every submission has is printed once.
void tell_notes(const std::vector<Graded>& graded);

/// Reports students whose answers are right for another student's scene.
void tell_answers_of_others(const std::vector<AnswersOfAnother>& found);

/// Reports students who have a scene of their own but handed nothing in.
void tell_not_handed_in(const Marking& marking, const std::vector<Graded>& graded);

/// Reports rows of --late-days that match no submission, because they may be misspelled. Also says so if late days cost
/// nothing by the rubric.
void tell_late_days(const report::LateDays& days, const reference::Rubric& rubric, const std::vector<Graded>& graded);

/// Reports overrides of submissions or items that are not in the class.
void tell_unmatched(const std::vector<KeptOverride>& overrides);

/// Reports overrides that give more points than their place is worth, perhaps because the rubric changed.
void tell_overrides_above_most(const std::vector<Graded>& graded);

/// Says that --apply removes students who are gone from the class from its results, and how to add one hand-in.
void tell_that_apply_takes_out(const ClassChanges& changes);

/// Reports rereads that do not count, and why.
void tell_that_count_not(const std::vector<KeptReread>& rereads, const std::vector<Graded>& graded);

}  // namespace harness
