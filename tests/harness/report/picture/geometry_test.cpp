// What pictures compute before they draw: clipping, circles, and the breaking of notes.
#include <gmock/gmock.h>

#include <cmath>

#include "harness/report/picture/clip.h"
#include "harness/report/picture/key.h"
#include "harness/report/picture/loop.h"
#include "reference/accuracy/rays/random_numbers.h"
#include "tests/given/report/drawn.h"

namespace harness::report::picture {
namespace {

using reference::accuracy::Random;

constexpr Box box{10, 20, 110, 80};

View view_from(const Point& toward, double distance) {
    View view;
    view.toward = reference::normalized(toward);
    const Point up = std::abs(view.toward.y) > 0.9 ? Point(1, 0, 0) : Point(0, 1, 0);
    view.right = reference::normalized(reference::cross(up, view.toward));
    view.up = reference::cross(view.toward, view.right);
    view.distance = distance;
    view.scale = 100;
    view.box = {-200, -200, 200, 200};
    return view;
}

TEST(ClipSegment, KeepsThePartInside) {
    Random random(1);
    int seen = 0;
    for (int i = 0; i < 500; ++i) {
        const Segment whole{{random.between(-100, 220), random.between(-100, 200), 0},
                            {random.between(-100, 220), random.between(-100, 200), 0}};
        const auto inside = clip_segment(whole, region_of(box));
        constexpr int steps = 500;
        for (int j = 0; j <= steps; ++j) {
            const Spot spot = whole.from + (whole.to - whole.from) * (j / double{steps});
            if (!box.holds(spot)) continue;
            ++seen;
            ASSERT_TRUE(inside);
            EXPECT_NEAR(distance(inside->from, spot) + distance(spot, inside->to), distance(inside->from, inside->to),
                        1e-9);
        }
        if (!inside) continue;
        for (const Spot& end : {inside->from, inside->to})
            EXPECT_TRUE((Box{box.left - 1e-9, box.top - 1e-9, box.right + 1e-9, box.bottom + 1e-9}.holds(end)));
    }
    EXPECT_GT(seen, 1000);
    EXPECT_FALSE(clip_segment({{NAN, 30, 0}, {50, 30, 0}}, region_of(box)));
    EXPECT_FALSE(clip_segment({{50, 30, 0}, {50, NAN, 0}}, region_of(box)));
    EXPECT_FALSE(clip_segment({{-5, 30, 0}, {-5, 70, 0}}, region_of(box)));
}

TEST(ClipPolygon, KeepsThePartInside) {
    EXPECT_EQ(clip_polygon({{0, 0, 0}, {60, 0, 0}, {60, 50, 0}, {0, 50, 0}}, region_of(box)),
              (std::vector<Point>{{60, 20, 0}, {60, 50, 0}, {10, 50, 0}, {10, 20, 0}}));
    EXPECT_EQ(clip_polygon({{0, 0, 0}, {9, 0, 0}, {9, 90, 0}}, region_of(box)), std::vector<Point>{});
    EXPECT_EQ(clip_polygon({{-1e9, -1e9, 0}, {1e9, -1e9, 0}, {0, 1e9, 0}}, region_of(box)).size(), 4U) << "the box";
}

TEST(ConvexHull, HasOnlyTheCorners) {
    EXPECT_EQ(convex_hull({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0}, {0, 0, 0}}),
              (std::vector<Spot>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
}

// Every spot lies on a line of sight that touches the ball, and the lines between spots stay close to the ball.
TEST(BallOutlines, TouchTheBall) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const View view = view_from(random.point(1), i % 2 == 0 ? 0 : 4);
        const Ball ball{random.point(0.8), random.between(0.1, 0.9)};
        const auto spots = outline_of(view, ball);
        ASSERT_GE(spots.size(), 12U) << i;
        for (std::size_t k = 0; k < spots.size(); ++k) {
            for (const Spot& spot : {spots[k], (spots[k] + spots[(k + 1) % spots.size()]) / 2.0}) {
                const Point on_plane = (view.right * spot.x - view.up * spot.y) / view.scale;
                const Point along = view.distance == 0 ? view.toward : view.toward * view.distance - on_plane;
                const double away =
                    reference::length(reference::cross(ball.center - on_plane, along)) / reference::length(along);
                EXPECT_NEAR(away, ball.radius, 0.004) << i;
            }
        }
    }
    EXPECT_TRUE(outline_of(view_from({0, 0, 1}, 4), {{0, 0, 3}, 2}).empty()) << "around the viewer";
    EXPECT_TRUE(outline_of(view_from({0, 0, 1}, 4), {{0, -3, 3}, 2.5}).empty()) << "beside the viewer";
}

// A circle as large as the Earth, through the middle of the page.
TEST(BallOutlines, StayRoundHoweverLarge) {
    const auto spots = outline_of(view_from({0, 0, 1}, 0), {{0, -1e8, 0}, 1e8});
    EXPECT_LT(spots.size(), 500U);
    int near = 0;
    for (const Spot& spot : spots) {
        if (std::abs(spot.x) > 200 || spot.y > 200) continue;
        ++near;
        EXPECT_NEAR(spot.y, 0, 1e-3);
    }
    const Region page{{-200, -200, -1}, {200, 200, 1}};
    EXPECT_NEAR(clip_polygon(spots, page).front().x, 200, 1e-9);
    EXPECT_GE(near, 0);
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
        for (const double turns : {edges->first, edges->second}) {
            const Spot top = view.spot(on_rim(tube, turns, 1)), bottom = view.spot(on_rim(tube, turns, -1));
            int left = 0, right = 0;
            for (int k = 0; k < 64; ++k) {
                const Spot spot = view.spot(on_rim(tube, k / 64.0, 1));
                const double away = reference::cross(bottom - top, spot - top).z / distance(top, bottom);
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

TEST(Notes, AreBrokenIntoLinesThatFitTheWidth) {
    const std::string note = "The ray misses the triangle: P_t is in its plane, but outside of it.";
    const NoteLines lines = draw_notes({note, "Short."}, 150, 100);
    const auto texts = drawn::texts_in(lines.svg);
    ASSERT_EQ(texts.size(), 4U);
    for (const drawn::Text& text : texts) EXPECT_LE(text.right - text.left, 150);
    EXPECT_EQ(texts[0].words + " " + texts[1].words + " " + texts[2].words, note);
    EXPECT_EQ(texts[3].words, "Short.");
    EXPECT_EQ(lines.bottom, 100 + 3 * line_height);
    const auto many = drawn::texts_in(draw_notes(std::vector<std::string>(25, "x"), 150, 100).svg);
    ASSERT_EQ(many.size(), 24U);
    EXPECT_EQ(many.back().words, "(more notes are left out here)");
}

}  // namespace
}  // namespace harness::report::picture
