// The outline of a ball as a view shows it.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/view.h"

namespace harness::report::picture {

/// The whole ellipse, filled; a <circle> if it is one.
std::string ellipse_svg(const Ellipse& ellipse);

/// Spots on the ellipse, at even angles.
std::vector<Spot> spots_of(const Ellipse& ellipse, int count);

}  // namespace harness::report::picture
