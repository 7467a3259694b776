// What a student printed, as far as it can be drawn.
#pragma once

#include <optional>
#include <string>

#include "harness/mark/score/score.h"
#include "harness/report/picture/scene_sketch.h"

namespace harness::report::picture {

/// The first three numbers of a printed point or vector; empty if there are fewer. They may be infinite or nan.
std::optional<Point> printed_vector(const std::string& printed);

/// Adds what was printed, and notes on what can't be drawn. With `right`, draws only the wrong answers, beside the
/// right ones. Without, draws all that was printed and nothing that comes from the key. Returns whether there is
/// anything to see of it.
bool draw_printed(const Score& score, const DoubleScene& scene, const std::optional<RightValues>& right,
                  const Frame& frame, Sketch& sketch);

}  // namespace harness::report::picture
