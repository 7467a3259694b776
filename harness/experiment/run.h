// Runs programs on other scenes to settle doubtful readings and to find the mistake behind a wrong answer.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/variants/rewritten/run_rewritten.h"

namespace harness::experiment {

/// One scene removes coincidences. The second helps with the first object hit, and with programs that end early on one
/// scene.
constexpr int scenes_tried = 2;

/// Whether runs on other scenes may settle the reading of an answer or find the mistake that made it wrong.
bool is_doubtful(const Graded& graded);

/// Fills in `experiment` of each submission with a doubtful answer and marks the submission again with the results. No
/// item loses points. All arguments must outlive the trial. `marking` is that of the class.
variants::Trial on_doubts(std::vector<Graded>& graded, const Marking& marking);

/// The source of each submission with a doubtful answer; an empty string for the others.
std::vector<std::string> doubtful_sources(const std::vector<Graded>& graded);

/// Runs only this trial, on submissions with their sources.
void settle_doubts(std::vector<Graded>& graded, const Marking& marking, const Runner& runner, int jobs,
                   Timeline& timeline);

}  // namespace harness::experiment
