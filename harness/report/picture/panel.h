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
    std::string shapes;  ///< SVG
    std::vector<Name> names;
    std::vector<Segment> drawn;  ///< lines that numbers should not hide
};
Panel draw_panel(const View& view, const Frame& frame, const Sketch& sketch);

/// Title, edge, the directions of the world's axes and, in a parallel view, how long a unit vector is.
std::string draw_box(const View& view, const Frame& frame);
/// What draw_box draws inside of the box.
std::vector<Box> taken_by_box(const View& view);

}  // namespace harness::report::picture
