// Clips lines and polygons to a box on the page.
#pragma once

#include <optional>
#include <vector>

#include "harness/report/picture/point.h"

namespace harness::report::picture {

/// The part of a segment inside the box, if any (Liang and Barsky 1984). Empty for numbers that are not finite.
std::optional<Segment> clip_segment(const Segment& segment, const Box& box);

/// The corners of the part of a convex polygon inside the box (Sutherland and Hodgman 1974); empty if there is none.
std::vector<Spot> clip_polygon(std::vector<Spot> corners, const Box& box);

}  // namespace harness::report::picture
