// Clips what is drawn to a box, in the plane or in space.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "harness/report/plot/label_placement.h"

namespace harness::report::picture {

template <std::size_t N>
using Coordinates = std::array<double, N>;

template <std::size_t N>
struct Region {
    Coordinates<N> low;
    Coordinates<N> high;
};

template <std::size_t N>
Coordinates<N> between(const Coordinates<N>& from, const Coordinates<N>& to, double share) {
    Coordinates<N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = from[i] + (to[i] - from[i]) * share;
    return result;
}

/// The part of a segment inside the region, if any (Liang and Barsky 1984). Empty for numbers that are not finite.
template <std::size_t N>
std::optional<std::pair<Coordinates<N>, Coordinates<N>>> clip_segment(const Coordinates<N>& from,
                                                                      const Coordinates<N>& to,
                                                                      const Region<N>& region) {
    double enter = 0;
    double leave = 1;
    for (std::size_t i = 0; i < N; ++i) {
        const double along = to[i] - from[i];
        if (along == 0) {
            if (!(from[i] >= region.low[i] && from[i] <= region.high[i])) return std::nullopt;
            continue;
        }
        const double low = (region.low[i] - from[i]) / along;
        const double high = (region.high[i] - from[i]) / along;
        if (!(low <= high || high <= low)) return std::nullopt;
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    if (!(enter <= leave)) return std::nullopt;
    return std::pair(enter == 0 ? from : between(from, to, enter), leave == 1 ? to : between(from, to, leave));
}

/// The corners of the part of a convex polygon inside the region (Sutherland and Hodgman 1974); empty if there is none.
template <std::size_t N>
std::vector<Coordinates<N>> clip_polygon(std::vector<Coordinates<N>> corners, const Region<N>& region) {
    for (std::size_t i = 0; i < 2 * N; ++i) {
        const std::size_t axis = i / 2;
        const double sign = i % 2 == 0 ? 1 : -1;
        const double bound = sign * (i % 2 == 0 ? region.low[axis] : region.high[axis]);
        std::vector<Coordinates<N>> kept;
        for (std::size_t j = 0; j < corners.size(); ++j) {
            const Coordinates<N>& from = corners[j];
            const Coordinates<N>& to = corners[(j + 1) % corners.size()];
            const double before = sign * from[axis] - bound;
            const double after = sign * to[axis] - bound;
            if (before >= 0) kept.push_back(from);
            if ((before > 0 && after < 0) || (before < 0 && after > 0)) {
                kept.push_back(between(from, to, before / (before - after)));
                kept.back()[axis] = sign * bound;
            }
        }
        corners = std::move(kept);
    }
    return corners;
}

/// A part of a circle, clockwise on the page.
struct Arc {
    Spot from;
    Spot to;
    bool is_large = false;  ///< more than half of the circle
};

/// The part of a disc inside a box.
struct DiscInBox {
    bool is_whole = false;     ///< the disc is inside the box; everything else is then empty
    bool fills_box = false;    ///< the box is inside the disc; everything else is then empty
    std::vector<Arc> arcs;     ///< the circle's parts in the box, clockwise
    std::vector<Spot> border;  ///< outline of the part, clockwise: an arc leads from a `leaves` spot to the next spot
    std::vector<bool> leaves;  ///< for each spot of `border`: the outline leaves the box's side there for the circle
};
DiscInBox clip_disc(const Spot& middle, double radius, const Box& box);

}  // namespace harness::report::picture
