// One view of a sketch, as SVG, and the points in it that get a number.
#pragma once

#include "harness/report/picture/svg.h"
#include "harness/report/picture/view.h"

namespace harness::report::picture {

struct Name {
    Spot at;
    std::string text;
    Ink ink = Ink::camera;
};

/// The drawing of a sketch, clipped to the view's box.
struct Panel {
    std::string svg;
    std::vector<Name> names;
    Box room;                    ///< for the numbers
    std::vector<Segment> drawn;  ///< lines that numbers should not hide
    std::vector<Box> taken;      ///< where no number may be
};
/// With the view's title and edge, and the directions of the world's axes.
Panel draw_panel(const View& view, const Frame& frame, const Sketch& sketch);

}  // namespace harness::report::picture
