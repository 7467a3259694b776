// An assignment's scene as intervals, for follow-through.
#pragma once

#include <vector>

#include "harness/mark/compare/item_targets.h"
#include "reference/key/answer.h"
#include "reference/toml/assignment.h"

namespace harness {

/// The scene's numbers as the nearest doubles. With several objects of a kind, the one that the questions are
/// about comes first.
struct IntervalScene : reference::Scene<Interval> {
    std::vector<reference::Boundary> boundaries;  ///< the rubric's accepted ways to count a hit at exactly t = 0
    double size = 1;                              ///< the scene's largest coordinate, at least 1
};

IntervalScene real_scene(const reference::Assignment& assignment, const reference::Reading& reading);

}  // namespace harness
