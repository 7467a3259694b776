// How the ray meets the cylinder in the other scenes: clearly, so that no float program mistakes it.
#pragma once

#include "harness/variants/random/cylinder_meeting.h"
#include "harness/variants/random/draw.h"

namespace harness::variants {

enum class CylinderRole {
    tube,    ///< hit on the tube
    cap,     ///< hit on the cap that faces the ray
    above,   ///< missed above the top cap or below the bottom cap, although the endless tube is hit
    beside,  ///< missed beside the tube
};

/// `role`, or one like it that a ray of this direction can play: a level ray hits no cap, an upright one no tube.
CylinderRole possible_role(CylinderRole role, const reference::Vec3<double>& V);

/// What of the cylinder may be drawn; the rest stays as it is.
struct CylinderParts {
    bool center = false;
    bool radius = false;
    bool height = false;
};

/// Draws a cylinder at a distance of `least` to `most` along the ray, which mostly plays the role. All numbers are
/// whole, the height is even, and lengths grow with `size`. If its height stays, then so does the height that it is at,
/// because many sources state the caps only within formulas.
reference::Cylinder<double> draw_cylinder(const reference::Cylinder<double>& from, const CylinderParts& parts,
                                          const reference::CameraAnswers<double>& ray, CylinderRole role, double size,
                                          double least, double most, Draw& draw);

bool plays(CylinderRole role, const CylinderMeeting& meeting);

}  // namespace harness::variants
