// The results of the other scenes in neutral words: no right value is shown, and nobody's intentions are judged.
#pragma once

#include <string>
#include <vector>

#include "harness/mark/score/doubts_text.h"
#include "harness/record/variants.h"

namespace harness {

/// For the flag: one unmoved number on both scenes, the change between the scenes, and the names of the other unmoved
/// items.
std::string unmoved_evidence(const VariantsReport& report);

/// A sentence for each reason why the program could not be run on some scenes. Empty if it ran on all scenes.
std::vector<std::string> not_tried_sentences(const VariantsReport& report);

/// For the student, one sentence on each topic: the runs, the items that moved, those that did not move, those that
/// broke and where, and the scenes that could not be tried. The sentences contain unescaped text from the program; the
/// caller must escape them.
std::vector<std::string> variants_sentences(const VariantsReport& report, Audience audience = Audience::instructor);

}  // namespace harness
