// The part of the world that a picture shows, and its scale.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/point.h"
#include "reference/stages/scene.h"

namespace harness::report::picture {

using DoubleScene = reference::Scene<double>;

/// A box along the world's axes. Pictures are drawn in its units: its middle is the origin, its longest half side 1.
struct Frame {
    Point middle;
    double unit = 1;   ///< the longest half side, in world units; > 0
    Point half;        ///< its half sides, in frame units: at most 1
    double arrow = 1;  ///< length at which a unit vector is drawn, in world units; 1 if that is a good size

    /// Into frame units.
    Point inside(const Point& world) const { return (world - middle) / unit; }
    bool holds(const Point& world) const;
};

/// Holds the eye, the image plane and everything that is not very much farther from the eye. Depends only on what the
/// handout gives and on `more`: the image plane's corners and whatever else is known. With `mistakes` it also holds an
/// image plane turned any other way, even behind the eye. `notes` tells what is left out.
Frame choose_frame(const DoubleScene& scene, const std::vector<Point>& more, bool mistakes,
                   std::vector<std::string>& notes);

/// From the eye towards lookat, length 1.
Point view_direction(const reference::Camera<double>& camera);

// Opposite corners of a box around the object or, of a triangle, its corners. Their mean is the object's middle.
std::vector<Point> extent_of(const reference::Sphere<double>& sphere);
std::vector<Point> extent_of(const reference::Triangle<double>& triangle);
std::vector<Point> extent_of(const reference::Cylinder<double>& cylinder);

}  // namespace harness::report::picture
