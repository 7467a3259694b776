#include "harness/report/picture/outline.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "harness/report/picture/ink.h"

namespace harness::report::picture {

std::string ellipse_svg(const Ellipse& ellipse) {
    const std::string colour(colour_of(Ink::sphere));
    const std::string look =
        fmt::format(" fill=\"{0}\" fill-opacity=\".13\" stroke=\"{0}\" stroke-width=\"1.6\"", colour);
    if (ellipse.along == ellipse.across) {
        return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>", coordinate(ellipse.middle.x),
                           coordinate(ellipse.middle.y), coordinate(ellipse.along), look);
    }
    const std::string x = coordinate(ellipse.middle.x);
    const std::string y = coordinate(ellipse.middle.y);
    return fmt::format("<ellipse cx=\"{0}\" cy=\"{1}\" rx=\"{2}\" ry=\"{3}\" transform=\"rotate({4} {0} {1})\"{5}/>", x,
                       y, coordinate(ellipse.along), coordinate(ellipse.across), coordinate(ellipse.angle), look);
}

std::vector<Spot> spots_of(const Ellipse& ellipse, int count) {
    std::vector<Spot> spots;
    const double turn = ellipse.angle * std::numbers::pi / 180;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const double along = ellipse.along * std::cos(angle);
        const double across = ellipse.across * std::sin(angle);
        spots.push_back({ellipse.middle.x + along * std::cos(turn) - across * std::sin(turn),
                         ellipse.middle.y + along * std::sin(turn) + across * std::cos(turn)});
    }
    return spots;
}

}  // namespace harness::report::picture
