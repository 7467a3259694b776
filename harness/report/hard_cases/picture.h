// A small picture of a hard case.
#pragma once

#include <string>

#include "reference/hard_cases/cases.h"

namespace harness::report {

/// SVG without a frame, around (0, 0), at most 100 wide and 52 high: a sphere with its ray in their common plane, a
/// triangle in its own plane with the hit point, a cylinder from the side or, with a level ray, from above, a camera's
/// view direction and vup. Objects too far away for the picture are drawn nearer.
std::string drawing_of(const reference::hard_cases::Case& hard);

}  // namespace harness::report
