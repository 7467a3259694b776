// What the hard scenes showed, in words: no right value.
#pragma once

#include <string>
#include <vector>

#include "harness/stress/stress_report.h"

namespace harness::stress {

/// "nan in 6.hit and 7.normal; 6.t keeps 2 of 6 digits": one scene's losses; empty when there are none.
std::string losses_in_words(const std::vector<HardItem>& items);

/// For the student's page, a sentence or a few each: how many scenes were survived, what was lost on which, and which
/// formulas keep more. Empty when no scene was tried. Text of the program's own is in none of them.
std::vector<std::string> stress_sentences(const StressReport& report);

/// The same for a terminal, scene by scene, those that were left out with the reason. Ends in a newline.
std::string stress_text(const StressReport& report);

}  // namespace harness::stress
