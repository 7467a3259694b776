// A scatter plot with names beside its points: time on the x axis, errors on the y axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harness::report {

/// Marks differ in shape as well as in colour.
enum class Mark {
    circle,   ///< float
    square,   ///< double
    diamond,  ///< any other scalar
};

struct ScatterPoint {
    std::string name;
    std::string told;  ///< a sentence with the numbers, for the tooltip and for screen readers
    Mark mark = Mark::circle;
    double x = 0;
    double x_low = 0;
    double x_high = 0;
    double y = 0;
    double y_low = 0;  ///< y_low = y_high if there is no interval
    double y_high = 0;
    bool on_frontier = false;
    bool is_named = true;  ///< its name stands beside it; else only in its tooltip, and the mark is pale
};

struct Scatter {
    std::string id;           ///< unique in the page: letters, digits and '-'
    std::string title;        ///< drawn, and read out
    std::string description;  ///< read out
    std::string x_title;
    std::string y_title;
    std::string band_title;         ///< what the band below the scale stands for; empty for no band
    double least = 0;               ///< values below are in the band; > 0
    double most = 0;                ///< the scale ends at this value or higher
    std::optional<double> ceiling;  ///< the scale never ends higher than this
    std::vector<ScatterPoint> points;
};

}  // namespace harness::report
