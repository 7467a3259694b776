// One view of a sketch, as SVG, and the names in it.
#pragma once

#include "harness/report/picture/ink.h"
#include "harness/report/picture/view.h"

namespace harness::report::picture {

struct Name {
    Spot at;
    std::string text;
};

/// What is drawn of a sketch, cut to the view's box.
struct Panel {
    std::string shapes;  ///< SVG
    std::vector<Name> names;
    std::vector<Segment> drawn;  ///< what names should rather not hide
};
Panel draw_panel(const View& view, const Frame& frame, const Sketch& sketch);

/// Names beside their points, as SVG. Names of one spot become one, as "B, C".
struct Names {
    std::string svg;
    std::vector<Box> taken;  ///< by them and their points' marks
};
/// No name touches another or what is `taken`; where there is too little room the last ones are left out.
Names place_names(const std::vector<Name>& names, const Box& box, const std::vector<Segment>& drawn,
                  const std::vector<Box>& taken);

/// Title, edge, the directions of the world's axes and, in a parallel view, how long a unit vector is.
std::string draw_box(const View& view, const Frame& frame);
/// What draw_box draws inside of the box.
std::vector<Box> taken_by_box(const View& view);

inline constexpr double letter_size = 12;
inline constexpr double line_height = 15;

}  // namespace harness::report::picture
