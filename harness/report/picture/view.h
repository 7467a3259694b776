// The views that a picture gives of the world: parallel projections, so that they distort nothing along their axes.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/frame.h"

namespace harness::report::picture {

/// All directions are unit vectors, at right angles.
struct View {
    std::string title;
    Point right;
    Point up;
    Point toward;      ///< towards the viewer
    double scale = 1;  ///< page units for one frame unit
    Box box;           ///< where the view is drawn; the frame's middle is its middle

    /// The place on the page of a point in frame units.
    Spot spot(const Point& point) const {
        return box.middle() + Spot(reference::dot(point, right), -reference::dot(point, up), 0) * scale;
    }
    /// Whether it looks along none of the world's axes.
    bool is_oblique() const;
};

/// From a corner of the room behind the camera, from the side and from above or, if the camera looks up or down, from
/// the front. The camera looks to the right from the side. They depend only on what the handout gives, and they only
/// reorder and flip the axes, so that they give no answer away.
std::vector<View> views_of(const DoubleScene& scene, const Frame& frame);

}  // namespace harness::report::picture
