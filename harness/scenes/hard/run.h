// Runs a class on the hard scenes. The results are feedback only and change no marks.
#pragma once

#include <string>
#include <vector>

#include "harness/grade/graded.h"
#include "harness/grade/marking.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"

namespace harness::scenes {

/// Fills `hard_scenes` of each result that has a right answer. `sources` are those of the results. Each source is
/// rewritten, compiled, run and cached as for other scenes; the caller turns repetitions and sanitizers off. A fault of
/// raygrade's becomes a note of the submission and leaves its marks as they are.
void run_hard_scenes(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                     const Runner& runner, int jobs, Timeline& timeline);

}  // namespace harness::scenes
