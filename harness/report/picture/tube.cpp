#include "harness/report/picture/tube.h"

#include <cmath>
#include <numbers>

namespace harness::report::picture {
namespace {

constexpr int corners_around = 24;

Coordinates<3> coordinates_of(const Point& p) {
    return {p.x, p.y, p.z};
}

bool holds(const Tube& tube, const Point& point) {
    const double height = std::abs(point.y - tube.center.y);
    return std::hypot(point.x - tube.center.x, point.z - tube.center.z) <= tube.radius && height <= tube.height / 2;
}

/// Twice the area of the triangle; above 0 if it is counterclockwise.
double turn(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

Point on_rim(const Tube& tube, double turns, int side) {
    const double angle = 2 * std::numbers::pi * turns;
    return tube.center + Point(tube.radius * std::cos(angle), side * tube.height / 2, tube.radius * std::sin(angle));
}

// The tube's tangent plane at an edge goes through the viewer, or is parallel to a parallel view.
std::optional<std::pair<double, double>> edges_of(const Tube& tube, const View& view) {
    const Point towards = view.distance == 0 ? view.toward : view.toward * view.distance - tube.center;
    const double level = std::hypot(towards.x, towards.z);
    constexpr double least = 1e-9;
    const double reach = view.distance == 0 ? 0 : tube.radius;
    if (!(level > reach) || !(level > least)) return std::nullopt;
    const double middle = std::atan2(towards.z, towards.x);
    const double aside = std::acos(reach / level);
    return std::pair((middle - aside) / (2 * std::numbers::pi), (middle + aside) / (2 * std::numbers::pi));
}

std::vector<Coordinates<3>> corners_within(const Tube& tube, const Region<3>& region) {
    std::vector<Coordinates<3>> corners;
    const auto add = [&](const std::vector<Coordinates<3>>& face) {
        const auto inside = clip_polygon(face, region);
        corners.insert(corners.end(), inside.begin(), inside.end());
    };
    const auto at = [&](int i, int side) {
        return coordinates_of(on_rim(tube, static_cast<double>(i) / corners_around, side));
    };
    std::vector<Coordinates<3>> top;
    std::vector<Coordinates<3>> bottom;
    for (int i = 0; i < corners_around; ++i) {
        top.push_back(at(i, 1));
        bottom.push_back(at(i, -1));
        add({at(i, 1), at(i + 1, 1), at(i + 1, -1), at(i, -1)});
    }
    add(top);
    add(bottom);
    for (int i = 0; i < 8; ++i) {
        const Point corner((i & 1) == 0 ? region.low[0] : region.high[0], (i & 2) == 0 ? region.low[1] : region.high[1],
                           (i & 4) == 0 ? region.low[2] : region.high[2]);
        if (holds(tube, corner)) corners.push_back(coordinates_of(corner));
    }
    return corners;
}

std::vector<Coordinates<2>> convex_hull(std::vector<Coordinates<2>> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Coordinates<2>> hull;
    const auto add = [&](const Coordinates<2>& point, std::size_t first) {
        while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
        hull.push_back(point);
    };
    for (const auto& point : points) add(point, 0);
    const std::size_t back = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], back);
    hull.pop_back();
    return hull;
}

}  // namespace harness::report::picture
