// Tries a class on the hard scenes. The results are feedback only and change no marks.
#pragma once

#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/variants/rewritten/run_rewritten.h"

namespace harness::stress {

/// Fills `hard_scenes` of each result that has a right answer. A fault of raygrade's becomes a note of the submission
/// and leaves its marks as they are. All that is given must outlive the trial.
variants::Trial on_hard_scenes(std::vector<Graded>& graded, const Marking& marking);

}  // namespace harness::stress
