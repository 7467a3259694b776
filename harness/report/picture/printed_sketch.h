// What a student printed, as far as it can be drawn.
#pragma once

#include "harness/report/picture/assignment_sketch.h"
#include "harness/score.h"

namespace harness::report::picture {

/// The printed point or vector: its first three numbers; empty where there are fewer. Not always finite.
std::optional<Point> printed_vector(const std::string& printed);

struct PrintedSketch {
    Sketch sketch;               ///< what can't be drawn is named in its notes
    std::optional<Point> P_VCS;  ///< of question 1, for the image plane
    bool is_P_VCS_right = false;
};

/// With `right` only what is not right, beside the right things; without, all that was printed, by itself: nothing of
/// it comes from the key then.
PrintedSketch printed_sketch(const Score& score, const DoubleScene& scene, const RightValues* right,
                             const Frame& frame);

}  // namespace harness::report::picture
