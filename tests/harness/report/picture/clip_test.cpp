// Compares clipping to a box with a test of every spot.
#include "harness/report/picture/clip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/accuracy/rays/random_numbers.h"

namespace {

using namespace harness::report;
using namespace harness::report::picture;
using reference::accuracy::Random;

constexpr Box box{10, 20, 110, 80};
constexpr Region<2> region{{10, 20}, {110, 80}};

bool in_box(const Spot& spot, double slack) {
    return spot.x > box.left - slack && spot.x < box.right + slack && spot.y > box.top - slack &&
           spot.y < box.bottom + slack;
}

TEST(ClipSegment, KeepsOnlyThePartInside) {
    Random random(1);
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const Coordinates<2> from{random.between(-100, 200), random.between(-100, 200)};
        const Coordinates<2> to{random.between(-100, 200), random.between(-100, 200)};
        const auto inside = clip_segment(from, to, region);
        double first = 2;
        double last = -1;
        constexpr int steps = 3000;
        for (int j = 0; j <= steps; ++j) {
            const auto spot = between(from, to, static_cast<double>(j) / steps);
            if (!in_box({spot[0], spot[1]}, 0)) continue;
            first = std::min(first, static_cast<double>(j) / steps);
            last = static_cast<double>(j) / steps;
        }
        if (last < 0) continue;  // nothing inside, or only a corner between two steps
        ASSERT_TRUE(inside);
        ++seen;
        const double step = std::hypot(to[0] - from[0], to[1] - from[1]) / steps;
        const auto begin = between(from, to, first);
        const auto end = between(from, to, last);
        EXPECT_NEAR(std::hypot(inside->first[0] - begin[0], inside->first[1] - begin[1]), 0, step + 1e-9);
        EXPECT_NEAR(std::hypot(inside->second[0] - end[0], inside->second[1] - end[1]), 0, step + 1e-9);
    }
    EXPECT_GT(seen, 300);
}

TEST(ClipSegment, RefusesNan) {
    EXPECT_FALSE(clip_segment<2>({NAN, 30}, {50, 30}, region));
    EXPECT_FALSE(clip_segment<2>({50, 30}, {50, NAN}, region));
    EXPECT_FALSE(clip_segment<2>({NAN, NAN}, {NAN, NAN}, region));
    EXPECT_FALSE(clip_segment<2>({-5, 30}, {-5, 70}, region));
}

/// Twice the area; positive for a polygon that runs clockwise on the page.
double area(const std::vector<Coordinates<2>>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& one = corners[i];
        const auto& next = corners[(i + 1) % corners.size()];
        sum += one[0] * next[1] - one[1] * next[0];
    }
    return sum / 2;
}

TEST(ClipPolygon, KeepsTheAreaInside) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        std::vector<Coordinates<2>> corners;
        for (int j = 0; j < 3; ++j) corners.push_back({random.between(-50, 170), random.between(-50, 150)});
        const double turn = area(corners) > 0 ? 1 : -1;
        int inside = 0;
        constexpr int steps = 200;
        for (int x = 0; x < steps; ++x) {
            for (int y = 0; y < steps; ++y) {
                const Spot spot{box.left + (x + 0.5) * 100 / steps, box.top + (y + 0.5) * 60 / steps};
                bool in = true;
                for (std::size_t j = 0; j < 3; ++j)
                    in = in && turn * area({corners[j], corners[(j + 1) % 3], {spot.x, spot.y}}) > 0;
                inside += in ? 1 : 0;
            }
        }
        const double expected = 6000.0 * inside / (steps * steps);
        EXPECT_NEAR(std::abs(area(clip_polygon(corners, region))), expected, 30);
    }
}

TEST(ClipDisc, FindsEveryArcInTheBox) {
    Random random(3);
    int cut = 0, filled = 0;
    for (int i = 0; i < 1000; ++i) {
        const Spot middle{random.between(-150, 250), random.between(-150, 250)};
        const double radius = random.between(1, 200);
        const DiscInBox disc = clip_disc(middle, radius, box);
        double length = 0;
        for (const Arc& arc : disc.arcs) {
            for (const Spot& end : {arc.from, arc.to}) {
                EXPECT_NEAR(std::hypot(end.x - middle.x, end.y - middle.y), radius, 1e-9);
                EXPECT_TRUE(in_box(end, 1e-9));
            }
            double turn = std::atan2(arc.to.y - middle.y, arc.to.x - middle.x) -
                          std::atan2(arc.from.y - middle.y, arc.from.x - middle.x);
            if (turn < 0) turn += 2 * M_PI;
            EXPECT_EQ(arc.is_large, turn > M_PI);
            length += turn * radius;
        }
        int inside = 0;
        constexpr int steps = 4000;
        for (int j = 0; j < steps; ++j) {
            const double angle = 2 * M_PI * (j + 0.5) / steps;
            if (in_box({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)}, 0)) ++inside;
        }
        const double expected = 2 * M_PI * radius * inside / steps;
        if (disc.is_whole) {
            EXPECT_EQ(inside, steps);
        } else {
            EXPECT_NEAR(length, expected, 10 * 2 * M_PI * radius / steps);
        }
        cut += disc.arcs.empty() ? 0 : 1;
        bool all_within = true;
        for (const double x : {box.left, box.right}) {
            for (const double y : {box.top, box.bottom})
                all_within = all_within && std::hypot(middle.x - x, middle.y - y) < radius;
        }
        EXPECT_EQ(disc.fills_box, all_within);
        filled += all_within ? 1 : 0;
    }
    EXPECT_GT(cut, 300);
    EXPECT_GT(filled, 20);
}

// A circle as large as the Earth, through the middle of the box.
TEST(ClipDisc, HandlesHugeCircles) {
    const double radius = 1e10;
    const DiscInBox disc = clip_disc({60, 50 + radius}, radius, box);
    ASSERT_EQ(disc.arcs.size(), 1U);
    EXPECT_NEAR(disc.arcs[0].from.y, 50, 1e-3);
    EXPECT_NEAR(disc.arcs[0].to.y, 50, 1e-3);
    EXPECT_EQ(std::abs(disc.arcs[0].from.x - disc.arcs[0].to.x), 100);
}

}  // namespace
