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

/// Sentences about what is lost. For the sphere and the triangle they say how many digits of t a method keeps on this
/// ray, in float and in double: the textbook's method and the first after it that keeps nearly a float's digits
/// (FLT_DIG - 1). For other answers they say how many digits the handout's steps keep. They contain no value of the
/// key. Empty if nothing is lost.
std::vector<std::string> better_formulas(const std::vector<HardItem>& lost, const Marking& marking);

/// The formula of a method, in one line: "q = -(b + sign(b) √d) / 2, t = q/a or c/q". Empty for an unknown kernel.
std::string_view formula_of(std::string_view kernel);

}  // namespace harness::scenes
