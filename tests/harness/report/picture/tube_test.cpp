#include "harness/report/picture/tube.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/accuracy/rays/random_numbers.h"

namespace harness::report::picture {
namespace {

using reference::accuracy::Random;

View view_from(const Point& toward, double distance) {
    View view;
    view.toward = reference::normalized(toward);
    const Point up = std::abs(view.toward.y) > 0.9 ? Point(1, 0, 0) : Point(0, 1, 0);
    view.right = reference::normalized(reference::cross(up, view.toward));
    view.up = reference::cross(view.toward, view.right);
    view.distance = distance;
    view.scale = 100;
    return view;
}

bool is_inside(const std::vector<Coordinates<2>>& hull, const Coordinates<2>& point, double slack) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const auto& a = hull[i];
        const auto& b = hull[(i + 1) % hull.size()];
        const double area = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
        if (area < -slack * std::hypot(b[0] - a[0], b[1] - a[1])) return false;
    }
    return true;
}

TEST(ConvexHull, HoldsAllPointsAndHasOnlyTheirCorners) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        std::vector<Coordinates<2>> points;
        for (int k = 0; k < 40; ++k) points.push_back({std::round(random.between(-5, 5)), random.between(-5, 5)});
        const auto hull = convex_hull(points);
        for (const auto& point : points) EXPECT_TRUE(is_inside(hull, point, 1e-12));
        for (const auto& corner : hull) EXPECT_NE(std::find(points.begin(), points.end(), corner), points.end());
    }
    const auto square = convex_hull({{0, 0}, {1, 1}, {0, 1}, {1, 0}, {0.5, 0.5}, {0.5, 0}, {0, 0}});
    EXPECT_EQ(square, (std::vector<Coordinates<2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

// On the page an edge is where the tube ends: no other line from rim to rim reaches beyond it.
TEST(TubeEdges, BoundTheTubeOnThePage) {
    Random random(2);
    int with_edges = 0;
    for (int i = 0; i < 300; ++i) {
        const View view = view_from(random.point(1), i % 2 == 0 ? 0 : 4);
        const Tube tube{random.point(0.4), random.between(0.05, 0.4), random.between(0.1, 0.8)};
        const auto edges = edges_of(tube, view);
        if (!edges) continue;
        ++with_edges;
        std::vector<Coordinates<2>> sides;
        const auto on_page = [&](double turns, int side) {
            const Spot at = view.spot(on_rim(tube, turns, side));
            return Coordinates<2>{at.x, at.y};
        };
        for (const double turns : {edges->first, edges->second}) {
            const auto top = on_page(turns, 1), bottom = on_page(turns, -1);
            int left = 0, right = 0;
            for (int k = 0; k < 64; ++k) {
                const auto point = on_page(k / 64.0, 1);
                const double area =
                    (bottom[0] - top[0]) * (point[1] - top[1]) - (bottom[1] - top[1]) * (point[0] - top[0]);
                const double away = area / std::hypot(bottom[0] - top[0], bottom[1] - top[1]);
                if (away > 1e-6) ++left;
                if (away < -1e-6) ++right;
            }
            EXPECT_EQ(std::min(left, right), 0) << i;
        }
    }
    EXPECT_GT(with_edges, 200);
    EXPECT_FALSE(edges_of({{0, 0, 0}, 0.5, 1}, view_from({0, 1, 0}, 0)).has_value()) << "from above";
    EXPECT_FALSE(edges_of({{0, 0, 0}, 0.5, 1}, view_from({0.01, 1, 0}, 4)).has_value()) << "over the cap";
}

// A random point of the solid inside the region lies within the hull of the corners, on every page.
TEST(TubeCorners, BoundTheSolidInsideTheRegion) {
    Random random(3);
    const Region<3> region{{-1, -0.6, -0.8}, {1, 0.6, 0.8}};
    int inside = 0;
    for (int i = 0; i < 100; ++i) {
        const Tube tube{random.point(1.2), random.between(0.2, 3), random.between(0.2, 4)};
        const View view = view_from(random.point(1), 0);
        std::vector<Coordinates<2>> spots;
        for (const auto& corner : corners_within(tube, region)) {
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_GE(corner[k], region.low[k] - 1e-9);
                EXPECT_LE(corner[k], region.high[k] + 1e-9);
            }
            const Spot at = view.spot({corner[0], corner[1], corner[2]});
            spots.push_back({at.x, at.y});
        }
        const auto hull = convex_hull(spots);
        for (int k = 0; k < 40; ++k) {
            const Point point = random.point(1);
            const bool in_region = std::abs(point.y) <= 0.6 && std::abs(point.z) <= 0.8;
            const bool in_tube =
                std::hypot(point.x - tube.center.x, point.z - tube.center.z) <= tube.radius * std::cos(M_PI / 24) &&
                std::abs(point.y - tube.center.y) <= tube.height / 2;
            if (!in_region || !in_tube) continue;
            ++inside;
            const Spot at = view.spot(point);
            EXPECT_TRUE(is_inside(hull, {at.x, at.y}, 1e-6)) << i;
        }
    }
    EXPECT_GT(inside, 300);
    EXPECT_TRUE(corners_within({{9, 0, 0}, 1, 1}, region).empty());
}

}  // namespace
}  // namespace harness::report::picture
