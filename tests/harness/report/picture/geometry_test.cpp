// What pictures compute before they draw: clipping, outlines, and the breaking of notes.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "harness/report/picture/clip.h"
#include "harness/report/picture/legend.h"
#include "harness/report/picture/panel.h"
#include "reference/accuracy/rays/random_numbers.h"
#include "tests/given/report/drawn.h"

namespace harness::report::picture {
namespace {

using reference::accuracy::Random;

constexpr Box box{10, 20, 110, 80};

TEST(ClipSegment, KeepsThePartInside) {
    Random random(1);
    int seen = 0;
    for (int i = 0; i < 500; ++i) {
        const Segment whole{{random.between(-100, 220), random.between(-100, 200), 0},
                            {random.between(-100, 220), random.between(-100, 200), 0}};
        const auto inside = clip_segment(whole, box);
        constexpr int steps = 500;
        for (int j = 0; j <= steps; ++j) {
            const Spot spot = whole.from + (whole.to - whole.from) * (j / double{steps});
            if (spot.x < box.left || spot.x > box.right || spot.y < box.top || spot.y > box.bottom) continue;
            ++seen;
            ASSERT_TRUE(inside);
            EXPECT_NEAR(distance(inside->from, spot) + distance(spot, inside->to), distance(inside->from, inside->to),
                        1e-9);
        }
        if (!inside) continue;
        for (const Spot& end : {inside->from, inside->to}) {
            EXPECT_NEAR(end.x, std::clamp(end.x, box.left, box.right), 1e-9);
            EXPECT_NEAR(end.y, std::clamp(end.y, box.top, box.bottom), 1e-9);
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_FALSE(clip_segment({{NAN, 30, 0}, {50, 30, 0}}, box));
    EXPECT_FALSE(clip_segment({{50, 30, 0}, {50, NAN, 0}}, box));
    EXPECT_FALSE(clip_segment({{-5, 30, 0}, {-5, 70, 0}}, box));
}

TEST(ClipPolygon, KeepsThePartInside) {
    EXPECT_EQ(clip_polygon({{0, 0, 0}, {60, 0, 0}, {60, 50, 0}, {0, 50, 0}}, box),
              (std::vector<Point>{{60, 20, 0}, {60, 50, 0}, {10, 50, 0}, {10, 20, 0}}));
    EXPECT_EQ(clip_polygon({{0, 0, 0}, {9, 0, 0}, {9, 90, 0}}, box), std::vector<Point>{});
    EXPECT_EQ(clip_polygon({{-1e9, -1e9, 0}, {1e9, -1e9, 0}, {0, 1e9, 0}}, box).size(), 4U) << "the box";
}

View view_from(const Point& toward) {
    View view;
    view.toward = reference::normalized(toward);
    view.right = reference::normalized(reference::cross(Point(0.1, 1, 0.2), view.toward));
    view.up = reference::cross(view.toward, view.right);
    view.scale = 100;
    view.box = {-200, -200, 200, 200};
    return view;
}

const Frame unit_frame{{0, 0, 0}, 1, {2, 2, 2}, 1};

/// The spots of the first fill.
std::vector<drawn::Spot> outline_in(const Panel& panel) {
    const std::size_t begin = panel.svg.find("<g><path");
    return drawn::spots_in(panel.svg.substr(begin, panel.svg.find("/>", begin) + 2 - begin) + "<");
}

// The outline's spots are as far from the centre as a parallel view shows the ball, and so are the lines between them.
TEST(BallOutlines, AreRound) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const View view = view_from(random.point(1));
        const Ball ball{random.point(0.4), random.between(0.1, 0.9)};
        const Spot center = view.spot(ball.center);
        Sketch sketch;
        sketch.balls = {ball};
        const auto spots = outline_in(draw_panel(view, unit_frame, sketch));
        ASSERT_GE(spots.size(), 16U) << i;
        for (std::size_t k = 1; k < spots.size(); ++k) {
            const Spot one(spots[k - 1].x, spots[k - 1].y, 0), other(spots[k].x, spots[k].y, 0);
            EXPECT_NEAR(distance(one, center), 100 * ball.radius, 0.1) << i;
            EXPECT_NEAR(distance((one + other) / 2.0, center), 100 * ball.radius, 0.35) << i;
        }
    }
}

// A circle as large as the Earth, through the middle of the page.
TEST(BallOutlines, AreRoundEvenIfLarge) {
    Sketch sketch;
    sketch.balls = {{{0, -1e8, 0}, 1e8}};
    View view = view_from({0, 0, 1});
    view.right = {1, 0, 0};
    view.up = {0, 1, 0};
    const auto spots = outline_in(draw_panel(view, unit_frame, sketch));
    int level = 0;
    for (const drawn::Spot& spot : spots) level += std::abs(spot.y) < 2 ? 1 : 0;
    EXPECT_GE(level, 2) << "at the left and at the right";
}

// The outline is the smallest convex one around both rims.
TEST(TubeOutlines, HoldTheTubeOnThePage) {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const View view = view_from(random.point(1));
        const Tube tube{random.point(0.4), random.between(0.05, 0.4), random.between(0.1, 0.8)};
        Sketch sketch;
        sketch.tubes = {tube};
        const auto spots = outline_in(draw_panel(view, unit_frame, sketch));
        ASSERT_GE(spots.size(), 16U) << i;
        std::vector<Spot> rims;
        for (int k = 0; k < 128; ++k) {
            const double angle = k / 64.0 * 3.14159265358979;
            rims.push_back(
                view.spot(tube.center + Point(tube.radius * std::cos(angle), (k % 2 == 0 ? 0.5 : -0.5) * tube.height,
                                              tube.radius * std::sin(angle))));
        }
        for (std::size_t k = 0; k < spots.size(); ++k) {
            const Spot from(spots[k].x, spots[k].y, 0);
            const drawn::Spot& next = spots[(k + 1) % spots.size()];
            const Spot to(next.x, next.y, 0);
            const double length = distance(from, to);
            if (length < 1) continue;
            int left = 0, right = 0;
            for (const Spot& rim : rims) {
                const double away = reference::cross(to - from, rim - from).z / length;
                const double rounded = 0.5 + 0.15 * distance(from, rim) / length;  // as spots are, to a tenth
                left += away > rounded ? 1 : 0;
                right += away < -rounded ? 1 : 0;
            }
            EXPECT_EQ(std::min(left, right), 0) << i;
        }
    }
}

TEST(Notes, AreBrokenIntoLinesThatFitTheWidth) {
    const std::string note = "The ray misses the triangle: P_t is in its plane, but outside the triangle.";
    const NoteLines lines = draw_notes({note, "Short."}, 150, 100);
    const auto texts = drawn::texts_in(lines.svg);
    ASSERT_EQ(texts.size(), 4U);
    for (const drawn::Text& text : texts) EXPECT_LE(text.right - text.left, 150);
    EXPECT_EQ(texts[0].words + " " + texts[1].words + " " + texts[2].words, note);
    EXPECT_EQ(texts[3].words, "Short.");
    EXPECT_EQ(lines.bottom, 100 + 3 * line_height);
    const auto many = drawn::texts_in(draw_notes(std::vector<std::string>(25, "x"), 150, 100).svg);
    ASSERT_EQ(many.size(), 24U);
    EXPECT_EQ(many.back().words, "(more notes left out)");
}

}  // namespace
}  // namespace harness::report::picture
