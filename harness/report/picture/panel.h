// One view of a sketch, as SVG, and the names in it.
#pragma once

#include "harness/report/picture/ink.h"
#include "harness/report/picture/view.h"

namespace harness::report::picture {

struct Name {
    Spot at;
    std::string text;
};

/// The drawing of a sketch, clipped to the view's box.
struct Panel {
    std::string shapes;  ///< SVG
    std::vector<Name> names;
    std::vector<Segment> drawn;  ///< lines that names should not hide
};
Panel draw_panel(const View& view, const Frame& frame, const Sketch& sketch);

/// Names beside their points, as SVG. Names of the same spot are joined: "B, C".
struct Names {
    std::string svg;
    std::vector<Box> taken;  ///< by the names and their points' marks
};
/// No name touches another name or a `taken` box. If there is too little room, the last names are left out.
Names place_names(const std::vector<Name>& names, const Box& box, const std::vector<Segment>& drawn,
                  const std::vector<Box>& taken);

/// Title, edge, the directions of the world's axes and, in a parallel view, how long a unit vector is.
std::string draw_box(const View& view, const Frame& frame);
/// What draw_box draws inside of the box.
std::vector<Box> taken_by_box(const View& view);

inline constexpr double letter_size = 12;
inline constexpr double line_height = 15;

}  // namespace harness::report::picture
