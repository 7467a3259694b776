// How clearly a ray hits or misses a cylinder, for drawing scenes.
#pragma once

#include "reference/stages/scene_answers.h"

namespace harness::variants {

/// V must have length 1. Numbers that do not exist for the ray's direction are nan or infinite.
struct CylinderMeeting {
    double steepness;  ///< |V.y|: 0 for a ray parallel to the caps, 1 for a ray parallel to the axis
    double share;      ///< how deep in the tube the ray passes: 1 at the axis, 0 at the tube, below 0 outside
    double enters;     ///< t where the ray enters the tube, if it were endless
    double leaves;
    double height_at_enters;  ///< 1 at the top cap's plane, -1 at the bottom cap's
    double height_at_leaves;
    double cap_t;      ///< where the ray meets the plane of the cap that faces it
    double cap_share;  ///< how deep within this cap, like `share`
};

CylinderMeeting cylinder_meeting(const reference::CameraAnswers<double>& ray,
                                 const reference::Cylinder<double>& cylinder);

}  // namespace harness::variants
