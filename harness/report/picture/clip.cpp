#include "harness/report/picture/clip.h"

#include <algorithm>
#include <utility>

namespace harness::report::picture {
namespace {

/// Twice the area of the triangle; above 0 if it is counterclockwise.
double turn(const Spot& a, const Spot& b, const Spot& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::optional<Segment> clip_segment(const Segment& segment, const Region& region) {
    const auto& [from, to] = segment;
    double enter = 0;
    double leave = 1;
    for (int i = 0; i < 3; ++i) {
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
    return Segment{enter == 0 ? from : from + (to - from) * enter, leave == 1 ? to : from + (to - from) * leave};
}

std::vector<Point> clip_polygon(std::vector<Point> corners, const Region& region) {
    for (int i = 0; i < 6; ++i) {
        const int axis = i / 2;
        const double sign = i % 2 == 0 ? 1 : -1;
        const double bound = sign * (i % 2 == 0 ? region.low[axis] : region.high[axis]);
        std::vector<Point> kept;
        for (std::size_t j = 0; j < corners.size(); ++j) {
            const Point& from = corners[j];
            const Point& to = corners[(j + 1) % corners.size()];
            const double before = sign * from[axis] - bound;
            const double after = sign * to[axis] - bound;
            if (before >= 0) kept.push_back(from);
            if ((before > 0 && after < 0) || (before < 0 && after > 0)) {
                kept.push_back(from + (to - from) * (before / (before - after)));
                kept.back()[axis] = sign * bound;
            }
        }
        corners = std::move(kept);
    }
    return corners;
}

std::vector<Spot> convex_hull(std::vector<Spot> spots) {
    const auto order = [](const Spot& one, const Spot& other) {
        return std::pair(one.x, one.y) < std::pair(other.x, other.y);
    };
    std::sort(spots.begin(), spots.end(), order);
    spots.erase(std::unique(spots.begin(), spots.end()), spots.end());
    if (spots.size() < 3) return spots;
    std::vector<Spot> hull;
    const auto add = [&](const Spot& spot, std::size_t first) {
        while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), spot) <= 0) hull.pop_back();
        hull.push_back(spot);
    };
    for (const Spot& spot : spots) add(spot, 0);
    const std::size_t back = hull.size() - 1;
    for (std::size_t i = spots.size() - 1; i-- > 0;) add(spots[i], back);
    hull.pop_back();
    return hull;
}

}  // namespace harness::report::picture
