// Settles doubtful readings, and which mistake was made, by running programs on other scenes.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/variants/rewritten/run_rewritten.h"

namespace harness::experiment {

/// One scene removes coincidences. The second is for what is hit first, and for programs that end early on one.
constexpr int scenes_tried = 2;

/// Whether the program's runs on other scenes may settle how an answer is read, or tell which mistake made it wrong.
bool is_doubtful(const Graded& graded);

/// Fills `experiment` of each submission with a doubtful answer and marks it again with what the experiment shows. No
/// item loses points by that. All that is given must outlive the trial. `marking` is that of the class.
variants::Trial on_doubts(std::vector<Graded>& graded, const Marking& marking);

/// The source of each submission with a doubtful answer; empty for the others, which the trial does not concern.
std::vector<std::string> doubtful_sources(const std::vector<Graded>& graded);

/// Runs only this trial, on submissions with their sources.
void settle_doubts(std::vector<Graded>& graded, const Marking& marking, const Runner& runner, int jobs,
                   Timeline& timeline);

}  // namespace harness::experiment
