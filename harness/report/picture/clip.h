// Clips what is drawn to a box, on the page or in space.
#pragma once

#include <optional>
#include <vector>

#include "harness/report/picture/point.h"

namespace harness::report::picture {

struct Region {
    Point low;
    Point high;
};
inline Region region_of(const Box& box) {
    return {{box.left, box.top, -1}, {box.right, box.bottom, 1}};
}

/// The part of a segment inside the region, if any (Liang and Barsky 1984). Empty for numbers that are not finite.
std::optional<Segment> clip_segment(const Segment& segment, const Region& region);

/// The corners of the part of a convex polygon inside the region (Sutherland and Hodgman 1974); empty if there is none.
std::vector<Point> clip_polygon(std::vector<Point> corners, const Region& region);

/// The corners of the spots' convex hull, in order around it (Andrew's monotone chain).
std::vector<Spot> convex_hull(std::vector<Spot> spots);

}  // namespace harness::report::picture
