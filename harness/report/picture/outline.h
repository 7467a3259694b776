// The outline of a ball as a view shows it.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/view.h"

namespace harness::report::picture {

/// The whole of it, filled; a circle where it is one.
std::string ellipse_svg(const Ellipse& ellipse);

/// Spots of it, evenly by angle.
std::vector<Spot> spots_of(const Ellipse& ellipse, int count);

}  // namespace harness::report::picture
