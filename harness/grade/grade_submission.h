// The main path: a submission is compiled and run, its output is read and scored.
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "harness/grade/scene_memo.h"
#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/run/execute.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"

namespace harness {

/// Grades one submission. Never throws for an error of the submission, the machine or raygrade itself: then the outcome
/// is not_graded and the explanation says why.
Graded grade(const Submission& submission, const Marking& marking, const Runner& runner);

/// Marks a submission's output. `memo` may be null.
Graded mark(const Submission& submission, const Executions& executions, const Marking& marking, const Runner& runner,
            SceneMemo* memo, Timeline& timeline);

/// Gives a submission the score of its output, and flags answers that, according to its source and score, belong to
/// another scene, are written in the source, may have been misread, or mostly follow from wrong ones. Removes earlier
/// such flags; results of its runs on other scenes stay. Without the source, which may be too long to be kept, the
/// scene found in it before still counts.
void judge(Graded& graded, const Score& score, const std::string& source, const std::string& output,
           const Marking& marking, SceneMemo* memo);

/// Marks the kept output again with the submission's current rereads, as grading it again does. The marks for other
/// scenes stay, and so do the flags for runs that differ and for the scene of another student.
void mark_again(Graded& graded, const Marking& marking);

/// A submission without marks, because of a problem of its own, of the machine or of raygrade.
Graded ungraded(const Submission& submission, const std::string& why, const Marking& marking, const Runner& runner);

/// The result of `work`; or, if the submission has a problem or `work` throws, the submission ungraded.
Graded graded_or_not(const Submission& submission, const Marking& marking, const Runner& runner,
                     const std::function<Graded()>& work);

/// The message for an error in raygrade itself.
std::string fault_sentence(const std::exception& error);

}  // namespace harness
