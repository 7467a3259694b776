// From where a picture looks at the world.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/report/label_placement.h"
#include "harness/report/picture/frame.h"

namespace harness::report::picture {

struct Ellipse {
    Spot middle;
    double along = 0;   ///< half axis in the direction of `angle`
    double across = 0;  ///< the other one
    double angle = 0;   ///< degrees, clockwise on the page
};

/// A parallel view when `distance` is 0, else a perspective one. All directions are unit vectors, at right angles.
struct View {
    std::string title;
    Point right;
    Point up;
    Point toward;         ///< towards who looks
    double distance = 0;  ///< of who looks from the frame's middle, in frame units; more than the frame's corners have
    double scale = 1;     ///< page units for one frame unit, at the frame's middle
    Spot middle;          ///< of the frame, on the page
    Box box;              ///< what it is drawn in

    /// Of a point in frame units, inside the frame.
    Spot spot(const Point& point) const;
    /// How near a point in frame units is to who looks; the larger, the nearer.
    double nearness(const Point& point) const { return reference::dot(point, toward); }
    /// The outline of a ball in frame units; empty where who looks is in it, or so near that it has no closed outline.
    std::optional<Ellipse> outline(const Point& center, double radius) const;
};

/// Two parallel views along the world's axes, of one scale: from the side and from above, or, where the camera looks up
/// or down, from two sides. The camera looks to the right in both. Like the perspective view they come of what the
/// handout gives alone, and are turned by no more than the order and the signs of the axes, so that nothing can be read
/// out of them that it does not say.
std::vector<View> parallel_views(const DoubleScene& scene, const Frame& frame, const std::vector<Box>& boxes);

/// `content`, in frame units, fills the box.
View perspective_view(const DoubleScene& scene, const Box& box, const std::vector<Point>& content);

}  // namespace harness::report::picture
