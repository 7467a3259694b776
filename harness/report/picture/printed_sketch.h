// What a student printed, as far as it can be drawn.
#pragma once

#include <optional>
#include <string>

#include "harness/mark/score/score.h"
#include "harness/report/picture/frame.h"
#include "harness/report/picture/object_sketch.h"
#include "harness/report/picture/sketch.h"

namespace harness::report::picture {

/// The first three numbers of a printed point or vector; empty if there are fewer. They may be infinite or nan.
std::optional<Point> printed_vector(const std::string& printed);

struct PrintedSketch {
    Sketch sketch;               ///< what can't be drawn is named in its notes
    std::optional<Point> P_VCS;  ///< for the image plane
    std::string P_VCS_name;      ///< in notes: "P_VCS (question 1)"
    bool is_P_VCS_right = false;
};

/// With `right`, draws only the wrong answers, beside the right ones. Without, draws all that was printed and nothing
/// that comes from the key.
PrintedSketch printed_sketch(const Score& score, const DoubleScene& scene, const RightValues* right,
                             const Frame& frame);

}  // namespace harness::report::picture
