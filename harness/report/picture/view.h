// The views that a picture gives of the world.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/frame.h"

namespace harness::report::picture {

/// A parallel view when `distance` is 0, else a perspective one. All directions are unit vectors, at right angles.
struct View {
    std::string title;
    Point right;
    Point up;
    Point toward;          ///< towards the viewer
    double distance = 0;   ///< of the viewer from the frame's middle, in frame units; the frame's corners are nearer
    double scale = 1;      ///< page units for one frame unit, at the frame's middle
    Spot middle{0, 0, 0};  ///< the frame's middle, on the page
    Box box;               ///< where the view is drawn

    /// The place on the page of a point in frame units, which must be inside the frame.
    Spot spot(const Point& point) const;
    /// How near a point in frame units is to the viewer; larger is nearer.
    double nearness(const Point& point) const { return reference::dot(point, toward); }
};

/// Two parallel views along the world's axes, at the same scale: from the side and from above or, if the camera looks
/// up or down, from two sides. The camera looks to the right in both. Like the perspective view, they depend only on
/// what the handout gives, and they only reorder and flip the axes, so that they give no answer away.
std::vector<View> parallel_views(const DoubleScene& scene, const Frame& frame, const std::vector<Box>& boxes);

/// `content`, in frame units, fills the box.
View perspective_view(const DoubleScene& scene, const Box& box, const std::vector<Point>& content);

}  // namespace harness::report::picture
