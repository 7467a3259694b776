// The image plane as the eye sees it, with the pixel.
#pragma once

#include "harness/report/picture/panel.h"

namespace harness::report::picture {

/// Whether a point in camera coordinates is in the image plane's window, whatever its z.
bool is_in_window(const DoubleScene& scene, const Point& P_VCS);

/// Draws the sketch's pixels, which must be in the window. `with_field` marks the pixel by nothing but a field of a
/// coarse raster, so as not to give the answer away.
Panel draw_image_plane(const DoubleScene& scene, const Sketch& sketch, bool with_field);

}  // namespace harness::report::picture
