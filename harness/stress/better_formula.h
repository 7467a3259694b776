// Which formulas of the accuracy ladder keep more on one scene, by the names that `raygrade accuracy` gives them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/grade.h"
#include "harness/stress/stress_report.h"

namespace harness::stress {

/// Sentences about what is lost: for the sphere's and the triangle's answers how many digits of t the ladder's methods
/// keep on this very ray, up to the first that keeps float's, in float and in double; for the other answers the same of
/// the handout's steps. No value of the key is in them. Empty when nothing is lost.
std::vector<std::string> better_formulas(const std::vector<HardItem>& lost, const Marking& marking);

/// What a method of the ladder computes, in one line: "q = -(b + sign(b) √d)/2, then t = q/a and c/q". Empty for a
/// kernel of another name.
std::string_view formula_of(std::string_view kernel);

}  // namespace harness::stress
