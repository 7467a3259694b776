#include "harness/report/picture/clip.h"

#include <algorithm>
#include <utility>

namespace harness::report::picture {

std::optional<Segment> clip_segment(const Segment& segment, const Box& box) {
    const auto& [from, to] = segment;
    double enter = 0;
    double leave = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double along = to[axis] - from[axis];
        if (along == 0) {
            if (!(from[axis] >= box.low()[axis] && from[axis] <= box.high()[axis])) return std::nullopt;
            continue;
        }
        const double low = (box.low()[axis] - from[axis]) / along;
        const double high = (box.high()[axis] - from[axis]) / along;
        if (!(low <= high || high <= low)) return std::nullopt;
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    if (!(enter <= leave)) return std::nullopt;
    return Segment{enter == 0 ? from : from + (to - from) * enter, leave == 1 ? to : from + (to - from) * leave};
}

std::vector<Spot> clip_polygon(std::vector<Spot> corners, const Box& box) {
    for (int side = 0; side < 4; ++side) {
        const int axis = side / 2;
        const double sign = side % 2 == 0 ? 1 : -1;
        const double bound = sign * (side % 2 == 0 ? box.low()[axis] : box.high()[axis]);
        std::vector<Spot> kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Spot& from = corners[i];
            const Spot& to = corners[(i + 1) % corners.size()];
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

}  // namespace harness::report::picture
