#include "harness/report/picture/clip.h"

#include <cmath>

namespace harness::report::picture {
namespace {

/// Where a circle crosses a side of the box, in the side's order.
std::vector<Spot> crossings(const Spot& middle, double radius, const Spot& from, const Spot& to) {
    const bool level = from.y == to.y;
    const double away = level ? from.y - middle.y : from.x - middle.x;
    if (!(std::abs(away) < radius)) return {};
    const double half = std::sqrt((radius - away) * (radius + away));
    const double start = level ? from.x : from.y;
    const double end = level ? to.x : to.y;
    const double centre = level ? middle.x : middle.y;
    std::vector<double> places;
    for (const double place : {centre - half, centre + half}) {
        if (place > std::min(start, end) && place < std::max(start, end)) places.push_back(place);
    }
    if (start > end) std::reverse(places.begin(), places.end());
    std::vector<Spot> spots;
    for (const double place : places) spots.push_back(level ? Spot{place, from.y} : Spot{from.x, place});
    return spots;
}

/// Whether it is more than half a turn clockwise from one spot of a circle to another.
bool is_large_arc(const Spot& middle, const Spot& from, const Spot& to) {
    const double cross = (from.x - middle.x) * (to.y - middle.y) - (from.y - middle.y) * (to.x - middle.x);
    return cross < 0;  // y counts downwards
}

}  // namespace

DiscInBox clip_disc(const Spot& middle, double radius, const Box& box) {
    const std::array<Spot, 4> corners{
        {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}};
    bool inside = std::hypot(corners[0].x - middle.x, corners[0].y - middle.y) < radius;
    DiscInBox result;
    bool crossed = false;
    for (std::size_t i = 0; i < 4; ++i) {
        if (inside) {
            result.border.push_back(corners[i]);
            result.leaves.push_back(false);
        }
        for (const Spot& spot : crossings(middle, radius, corners[i], corners[(i + 1) % 4])) {
            crossed = true;
            result.border.push_back(spot);
            result.leaves.push_back(inside);
            inside = !inside;
        }
    }
    if (!crossed) {
        result.fills_box = inside;
        result.is_whole =
            !inside && middle.x > box.left && middle.x < box.right && middle.y > box.top && middle.y < box.bottom;
        result.border.clear();
        result.leaves.clear();
        return result;
    }
    for (std::size_t i = 0; i < result.border.size(); ++i) {
        if (!result.leaves[i]) continue;
        const Spot& to = result.border[(i + 1) % result.border.size()];
        result.arcs.push_back({result.border[i], to, is_large_arc(middle, result.border[i], to)});
    }
    return result;
}

}  // namespace harness::report::picture
