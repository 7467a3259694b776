// The part of the world that a picture shows, and its scale.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/point.h"
#include "reference/stages/scene.h"

namespace harness::report::picture {

using DoubleScene = reference::Scene<double>;

/// A box along the world's axes. It defines the frame units of pictures: its middle is the origin, its longest half
/// side has length 1.
struct Frame {
    Point middle;
    double unit = 1;   ///< the longest half side, in world units; > 0
    Point half;        ///< its half sides, in frame units: at most 1
    double arrow = 1;  ///< drawn length of a unit vector, in world units; 1 if that is a good size

    /// Converts a point to frame units.
    Point inside(const Point& world) const { return (world - middle) / unit; }
    bool holds(const Point& world) const;
};

/// Contains the eye, the image plane and everything that is not much farther from the eye. Depends only on the handout
/// and on `more`: the image plane's corners and any other known points. With `mistakes`, it also has room for an image
/// plane with any other orientation, even behind the eye. `notes` gets a note on everything left out.
Frame choose_frame(const DoubleScene& scene, const std::vector<Point>& more, bool mistakes,
                   std::vector<std::string>& notes);

/// From the eye towards lookat, length 1.
Point view_direction(const reference::Camera<double>& camera);

// Opposite corners of a box around the object, or a triangle's own corners. Their mean is the object's middle.
std::vector<Point> extent_of(const reference::Sphere<double>& sphere);
std::vector<Point> extent_of(const reference::Triangle<double>& triangle);
std::vector<Point> extent_of(const reference::Cylinder<double>& cylinder);

}  // namespace harness::report::picture
