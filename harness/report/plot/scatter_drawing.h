// Draws a scatter plot.
#pragma once

#include <string>

#include "harness/report/plot/scatter.h"

namespace harness::report {

struct Drawing {
    std::string svg;  ///< a whole <svg> element
    double width = 0;
    double height = 0;
};

Drawing draw(const Scatter& scatter);

/// The font of all text in pictures.
inline constexpr const char* font_family = "Helvetica, Arial, 'Liberation Sans', sans-serif";

}  // namespace harness::report
