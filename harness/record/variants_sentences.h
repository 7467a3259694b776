// The results of the other scenes in neutral words: no right value is shown, and nobody's intentions are judged.
#pragma once

#include <string>
#include <vector>

#include "harness/mark/score/doubts_text.h"
#include "harness/record/variants.h"

namespace harness {

/// For the flag: an unmoved number on both scenes with what changed between them, and the names of the other unmoved
/// items.
std::string unmoved_evidence(const VariantsReport& report);

/// A sentence for each reason why the program could not be run on some scenes. Empty if it ran on all scenes.
std::vector<std::string> not_tried_sentences(const VariantsReport& report);

/// For the student, a sentence each: what was tried, what moved, what did not move, what broke and where, and what
/// could not be tried. The sentences contain text from the program unescaped; the caller must escape them.
std::vector<std::string> variants_sentences(const VariantsReport& report, Audience audience = Audience::instructor);

}  // namespace harness
