// The outline of a cylinder whose axis is parallel to the world's y axis, as a view shows it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "harness/report/picture/clip.h"
#include "harness/report/picture/view.h"
#include "harness/report/sketch/sketch.h"

namespace harness::report::picture {

/// `turns` is the angle around the axis, in turns; `side` is 1 for the top cap's rim and -1 for the bottom cap's.
Point on_rim(const Tube& tube, double turns, int side);

/// The angles, in turns, of the two lines from rim to rim at the tube's edges; empty if the view shows the tube from
/// above, from below or from within. `tube` is in frame units.
std::optional<std::pair<double, double>> edges_of(const Tube& tube, const View& view);

/// The corners of the part of the tube inside the region, as a solid; empty if there is none.
std::vector<Coordinates<3>> corners_within(const Tube& tube, const Region<3>& region);

/// The convex hull's corners, in order around it (Andrew's monotone chain).
std::vector<Coordinates<2>> convex_hull(std::vector<Coordinates<2>> points);

}  // namespace harness::report::picture
