// The image plane as the eye sees it, with the pixel.
#pragma once

#include <optional>

#include "harness/report/picture/panel.h"

namespace harness::report::picture {

struct ImagePlane {
    std::string svg;  ///< without the names in it
    Box window;       ///< on the page
    Box room;         ///< for names, as a narrow window has too little room
    std::vector<Name> names;
    std::vector<Box> taken;  ///< where no name may stand
};

/// Without the right P_VCS, shows the pixel only as a field of a coarse raster, so as not to give the answer away.
ImagePlane draw_image_plane(const DoubleScene& scene, const std::optional<Point>& P_VCS, const Box& box);

/// Draws a printed P_VCS; if it is outside of the window, only adds a note, in which it has the `name`.
Panel draw_printed_pixel(const DoubleScene& scene, const Point& P_VCS, const std::string& name, bool is_right,
                         const Box& window, std::vector<std::string>& notes);

/// Places the names in the window or beside it.
Names place_names_in(const ImagePlane& plane, const std::vector<Name>& names, const std::vector<Box>& taken);

}  // namespace harness::report::picture
