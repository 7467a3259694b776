// The results of the hard scenes in words. No right value is shown.
#pragma once

#include <string>
#include <vector>

#include "harness/record/hard_scenes.h"

namespace harness {

/// The losses on a scene: "nan in 6.hit and 7.normal; 6.t keeps 2 of 6 digits". Empty if there are none.
std::string losses_in_words(const std::vector<HardItem>& items);

/// For the student's page, one or a few sentences each: how many scenes the program survived, and its losses on each
/// scene. Empty if no scene was tried. The sentences contain no text from the program.
std::vector<std::string> hard_scenes_sentences(const HardScenesReport& report);

/// The same for a terminal, scene by scene; a skipped scene comes with the reason. Ends in a newline.
std::string hard_scenes_text(const HardScenesReport& report);

}  // namespace harness
