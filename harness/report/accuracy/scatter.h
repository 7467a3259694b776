// A scatter plot of numbered points with a legend: time on the x axis, errors on the y axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harness::report {

struct ScatterPoint {
    int number = 0;       ///< drawn beside the point; the legend gives its name
    std::string name;     ///< of a method
    std::string details;  ///< a sentence with the figures, for the tooltip and for screen readers
    std::string scalar;   ///< decides the mark's shape and color
    double x = 0;
    double x_low = 0;
    double x_high = 0;
    double y = 0;
    double y_low = 0;  ///< y_low = y_high if there is no interval
    double y_high = 0;
    bool on_frontier = false;
};

struct Scatter {
    std::string id;           ///< unique in the page: letters, digits and '-'
    std::string title;        ///< drawn, and read out
    std::string description;  ///< read out
    std::string x_title;
    std::string y_title;
    std::string band_title{};         ///< the meaning of the band below the scale; empty for no band
    double least = 1;                 ///< values below are in the band; > 0
    std::optional<double> ceiling{};  ///< the scale never ends higher than this
    std::vector<ScatterPoint> points{};
};

/// A whole <svg> element. Points whose numbers would overlap share one label, "2, 3".
std::string draw(const Scatter& scatter);

}  // namespace harness::report
