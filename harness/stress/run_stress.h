// A class run on the hard scenes, for feedback alone.
#pragma once

#include <string>
#include <vector>

#include "harness/grade.h"
#include "harness/timeline.h"
#include "harness/workshop.h"

namespace harness::stress {

/// Fills `hard_scenes` of each result that has a right answer. `sources` are those of the results. Each source is
/// rewritten, compiled and run as for other scenes, and kept likewise; the caller turns repetitions and sanitizers off.
/// A fault of raygrade's in it is noted with the submission and leaves its marks as they are.
void run_stress(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                const Workshop& workshop, int jobs, Timeline& timeline);

}  // namespace harness::stress
