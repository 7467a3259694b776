// A picture of points with their names beside them: time across, what is wrong upwards.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harness::report {

/// Told apart by shape as well as colour.
enum class Mark {
    circle,   ///< float
    square,   ///< double
    diamond,  ///< any other scalar
};

struct ScatterPoint {
    std::string name;
    std::string told;  ///< a sentence with the numbers, for who points at it or listens
    Mark mark = Mark::circle;
    double x = 0;
    double x_low = 0;
    double x_high = 0;
    double y = 0;
    double y_low = 0;  ///< y_low = y_high where there is no interval
    double y_high = 0;
    bool on_frontier = false;
};

struct Scatter {
    std::string id;           ///< unique in the page: letters, digits and '-'
    std::string title;        ///< drawn, and read out
    std::string description;  ///< read out
    std::string x_title;
    std::string y_title;
    std::string band_title;         ///< what the band below the scale stands for; empty for no band
    double least = 0;               ///< values below are in the band; > 0
    double most = 0;                ///< where the scale ends at the least
    std::optional<double> ceiling;  ///< where it ends in any case
    std::vector<ScatterPoint> points;
};

struct Drawing {
    std::string svg;  ///< a whole <svg> element
    double width = 0;
    double height = 0;
};

Drawing draw(const Scatter& scatter);

/// The face of all text in pictures.
inline constexpr const char* font_family = "Helvetica, Arial, 'Liberation Sans', sans-serif";

}  // namespace harness::report
