// The image plane as the eye sees it, with the pixel.
#pragma once

#include <optional>

#include "harness/report/picture/frame.h"
#include "harness/report/picture/panel.h"

namespace harness::report::picture {

struct ImagePlane {
    Panel panel;
    Box window;  ///< on the page
    Box room;    ///< for numbers, as a narrow window has too little room
};

/// Without the right P_VCS, shows the pixel only as a field of a coarse raster, so as not to give the answer away.
ImagePlane draw_image_plane(const DoubleScene& scene, const std::optional<Point>& P_VCS, const Box& box);

/// Draws a printed P_VCS; if it is outside of the window, only adds a note, in which it has the `name`.
Panel draw_printed_pixel(const DoubleScene& scene, const Point& P_VCS, const std::string& name, bool is_right,
                         const Box& window, std::vector<std::string>& notes);

}  // namespace harness::report::picture
