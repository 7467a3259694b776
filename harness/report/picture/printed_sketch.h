// Drawings of a student's printed answers, as far as they can be drawn.
#pragma once

#include <optional>
#include <string>

#include "harness/mark/score/score.h"
#include "harness/report/picture/scene_sketch.h"

namespace harness::report::picture {

/// The first three numbers of a printed point or vector; empty if there are fewer. They may be infinite or nan.
std::optional<Point> printed_vector(const std::string& printed);

/// Adds the printed answers, and notes on those that can't be drawn. With `right`, draws only the wrong answers, next
/// to the right ones. Otherwise draws all printed answers and nothing from the key. Returns whether it drew anything.
bool draw_printed(const Score& score, const DoubleScene& scene, const std::optional<RightValues>& right,
                  const Frame& frame, Sketch& sketch);

}  // namespace harness::report::picture
