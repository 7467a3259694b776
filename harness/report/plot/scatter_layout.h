// Computes where everything in a scatter plot goes, before it is drawn.
#pragma once

#include "harness/report/plot/label_placement.h"
#include "harness/report/plot/log_axis.h"
#include "harness/report/plot/scatter.h"

namespace harness::report {

struct Frame {
    double width;
    double height;
    double left;  ///< edges of the plot itself
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
    std::vector<Spot> spots;                 ///< one per point; in the band each has its own line, fastest on top
    std::vector<std::vector<Segment>> bars;  ///< by point: quartiles and interval, if not empty
    std::vector<Segment> frontier;           ///< one step after the other
    std::vector<Box> names;                  ///< one per point that is named
};

/// The plot is as high as needed to keep the names apart.
Layout lay_out(const Scatter& scatter);

inline constexpr double name_size = 13;    ///< of the font
inline constexpr double name_height = 15;  ///< of a name's box

}  // namespace harness::report
