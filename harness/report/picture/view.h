// The views of the world in a picture: parallel projections, so they distort nothing along their axes.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/frame.h"

namespace harness::report::picture {

/// All directions are unit vectors at right angles to each other.
struct View {
    std::string title;
    Point right;
    Point up;
    Point toward;      ///< towards the viewer
    double scale = 1;  ///< page units for one frame unit
    Box box;           ///< where the view is drawn; the frame's middle is its middle

    /// The position on the page of a point in frame units.
    Spot spot(const Point& point) const {
        return box.middle() + Spot(reference::dot(point, right), -reference::dot(point, up), 0) * scale;
    }
    /// Whether the view direction is not along a world axis.
    bool is_oblique() const;
};

/// Three views: from a corner of the room behind the camera, from the side, and from above or, if the camera looks up
/// or down, from the front. In the view from the side, the camera looks to the right. The views depend only on the
/// handout, and they only reorder and flip the axes, so they reveal no answer.
std::vector<View> views_of(const DoubleScene& scene, const Frame& frame);

}  // namespace harness::report::picture
