// Tries a class on the hard scenes. The results are feedback only and change no marks.
#pragma once

#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/variants/rewritten/run_rewritten.h"

namespace harness::stress {

/// Fills in `hard_scenes` of each result that has a right answer. A failure of raygrade becomes a note on the
/// submission and does not change its marks. All arguments must outlive the trial.
variants::Trial on_hard_scenes(std::vector<Graded>& graded, const Marking& marking);

}  // namespace harness::stress
