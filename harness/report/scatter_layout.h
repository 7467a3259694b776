// Where everything of a scatter goes, before it is drawn.
#pragma once

#include "harness/report/label_placement.h"
#include "harness/report/log_axis.h"
#include "harness/report/scatter.h"

namespace harness::report {

struct Frame {
    double width;
    double height;
    double left;  ///< of the plot itself
    double right;
    double top;
    double bottom;
    double band;  ///< the height of the band at the bottom; 0 for none
    BentAxis x;
    LogAxis y;

    double band_top() const { return bottom - band; }
};

struct Layout {
    Frame frame;
    std::vector<Spot> spots;  ///< one a point. In the band each has a line of its own, fastest on top.
    std::vector<std::vector<Segment>>
        bars;                       ///< by point: quartiles and interval, as far as they are longer than nothing
    std::vector<Segment> frontier;  ///< one step after the other
    std::vector<Box> names;         ///< one a point
};

/// As high as the names need to keep apart.
Layout lay_out(const Scatter& scatter);

inline constexpr double name_size = 13;    ///< of the font
inline constexpr double name_height = 15;  ///< of a name's box

}  // namespace harness::report
