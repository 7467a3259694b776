// The scene of an assignment as follow-through computes with it.
#pragma once

#include <vector>

#include "harness/known.h"
#include "reference/answer_key.h"

namespace harness {

/// The scene's numbers as the nearest doubles. Where it holds several spheres or triangles, the one that the questions
/// are about comes first.
struct RealScene : reference::Scene<Real> {
    std::vector<reference::Boundary> boundaries;  ///< how the rubric lets a hit at t = 0 exactly count
    double size = 1;                              ///< its largest coordinate, at least 1
};

RealScene real_scene(const reference::Assignment& assignment, const reference::Reading& reading);

}  // namespace harness
