// Tells which formulas keep more digits on one scene. They are the methods that `raygrade accuracy` compares, under the
// same names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/grade/graded.h"
#include "harness/grade/hard_scenes.h"
#include "harness/grade/marking.h"

namespace harness::scenes {

/// Sentences about what is lost. For the sphere and the triangle they name a method that does better on this ray than
/// the program, in float and in double: the first that keeps nearly a float's digits of t (FLT_DIG - 1). If that is the
/// textbook's method in float, the formula is not at fault, and the sentence says so. For other answers they say how
/// many digits the handout's steps keep. They contain no value of the key. Empty if nothing is lost, or only what is
/// not printed.
std::vector<std::string> better_formulas(const std::vector<HardItem>& lost, const Marking& marking);

/// The formula of a method, in one line: "q = -(b + sign(b) √d) / 2, t = q/a or c/q". Empty for an unknown kernel.
std::string_view formula_of(std::string_view kernel);

}  // namespace harness::scenes
