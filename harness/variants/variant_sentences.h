// What the other scenes showed, in neutral words: no right value, and no word about anybody's intentions.
#pragma once

#include <string>
#include <vector>

#include "harness/variants/variant_report.h"
#include "harness/variants/written_answers.h"

namespace harness::variants {

/// For the flag: the first unmoved number on both scenes side by side with what changed, and the names of the others.
std::string unmoved_evidence(const VariantReport& report);

/// For the flag where the scene was not found: the printed numbers that stand in the source, with their lines.
std::string written_evidence(const std::vector<WrittenAnswer>& written);

/// On which scenes the program could not be run, and why: a sentence for each reason. Empty when it ran on all.
std::vector<std::string> not_tried_sentences(const VariantReport& report);

/// For the student, a sentence each: what was tried, what moved, what did not, what broke and where, what could not be
/// tried. Text that a program printed is in them as it is, so the caller escapes them.
std::vector<std::string> variant_sentences(const VariantReport& report);

}  // namespace harness::variants
