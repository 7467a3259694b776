// Circles in space, as a view shows them: the outline of a ball, the rims of a tube.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "harness/report/picture/sketch.h"
#include "harness/report/picture/view.h"

namespace harness::report::picture {

/// The spots of a circle around `middle`, whose points are `middle` + cos·`u` + sin·`v`, all in frame units. So close
/// together that lines from spot to spot look round in the view's box, however large the circle is. Empty if the view
/// does not have all of the circle before it.
std::vector<Spot> spots_of_circle(const View& view, const Point& middle, const Point& u, const Point& v);

/// The outline of a ball in frame units; empty if the viewer is in the ball, or so near that the outline is not closed.
std::vector<Spot> outline_of(const View& view, const Ball& ball);

/// `turns` is the angle around the axis, in turns; `side` is 1 for the top cap's rim and -1 for the bottom cap's.
Point on_rim(const Tube& tube, double turns, int side);

/// The angles, in turns, of the two lines from rim to rim at the tube's edges; empty if the view shows the tube from
/// above, from below or from within. `tube` is in frame units.
std::optional<std::pair<double, double>> edges_of(const Tube& tube, const View& view);

}  // namespace harness::report::picture
