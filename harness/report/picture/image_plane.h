// The image plane as the eye sees it, with the pixel.
#pragma once

#include "harness/report/picture/panel.h"

namespace harness::report::picture {

/// Whether a point in camera coordinates is in the image plane's window, whatever its z.
bool is_in_window(const DoubleScene& scene, const Point& P_VCS);

/// Draws the sketch's pixels, which must be in the window. `with_field` marks the pixel only by a field of a coarse
/// grid, to avoid revealing the answer.
Panel draw_image_plane(const DoubleScene& scene, const Sketch& sketch, bool with_field);

}  // namespace harness::report::picture
