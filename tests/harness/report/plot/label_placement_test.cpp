#include "harness/report/plot/label_placement.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace harness::report {
namespace {

constexpr Box page{0, 0, 400, 300};

bool touch(const Box& one, const Box& other) {
    return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

bool is_within(const Box& box, const Box& area) {
    return box.left >= area.left && box.right <= area.right && box.top >= area.top && box.bottom <= area.bottom;
}

double distance(const Label& label, const Box& box) {
    const Spot end = nearest_on(box, label.point);
    return std::hypot(end.x - label.point.x, end.y - label.point.y);
}

Box place_of(const Label& label, const std::vector<Segment>& drawn = {}, const PlaceSearch& search = {}) {
    const Placement placement = place_labels({label}, page, drawn, search);
    EXPECT_TRUE(placement.is_clear);
    return placement.boxes.at(0);
}

/// Distinct points whose labels have room next to each other.
std::vector<Label> scattered(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(20, 380), y(20, 280), width(20, 60);
    std::vector<Label> labels;
    for (int i = 0; i < count; ++i) labels.push_back({{x(random), y(random)}, width(random), 12});
    return labels;
}

TEST(LabelPlacement, PutsASingleLabelRightOfItsPointAtTheSameHeight) {
    const Box box = place_of({{200, 150}, 40, 12});
    EXPECT_NEAR((box.top + box.bottom) / 2, 150, 1e-9);
    EXPECT_NEAR(box.left, 209, 1e-9);
    EXPECT_NEAR(box.right - box.left, 40, 1e-9);
    EXPECT_NEAR(box.bottom - box.top, 12, 1e-9);
}

TEST(LabelPlacement, PutsALabelLeftOfItsPointAtTheRightEdge) {
    const Box box = place_of({{390, 150}, 40, 12});
    EXPECT_LT(box.right, 390);
    EXPECT_NEAR((box.top + box.bottom) / 2, 150, 1e-9);
}

TEST(LabelPlacement, AvoidsLinesAndTakenPlaces) {
    const Label label{{200, 150}, 40, 12};
    const Segment across{{205, 150}, {300, 150}};
    const Box beside_line = place_of(label, {across});
    EXPECT_FALSE(touch(beside_line, {205, 150 - 1e-9, 300, 150 + 1e-9}));
    const Box taken{205, 100, 300, 200};
    PlaceSearch search;
    search.taken = {taken};
    EXPECT_FALSE(touch(place_of(label, {}, search), taken));
    PlaceSearch careless;
    careless.price_of_drawn = 0;
    EXPECT_NEAR(place_of(label, {across}, careless).left, 209, 1e-9) << "a line that costs nothing is no reason";
}

TEST(LabelPlacement, KeepsManyApartOnThePageAndOffThePoints) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const std::vector<Label> labels = scattered(15, seed);
        const Placement placement = place_labels(labels, page, {});
        ASSERT_EQ(placement.boxes.size(), labels.size());
        EXPECT_TRUE(placement.is_clear) << seed;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_TRUE(is_within(placement.boxes[i], page)) << seed;
            EXPECT_LT(distance(labels[i], placement.boxes[i]), 100) << seed;
            for (std::size_t j = 0; j < labels.size(); ++j) {
                const Spot& point = labels[j].point;
                EXPECT_FALSE(touch(placement.boxes[i], {point.x - 5, point.y - 5, point.x + 5, point.y + 5})) << seed;
                EXPECT_FALSE(j < i && touch(placement.boxes[i], placement.boxes[j])) << seed;
            }
        }
    }
}

TEST(LabelPlacement, FindsRoomForACrowd) {
    std::vector<Label> labels;
    for (int i = 0; i < 8; ++i) labels.push_back({{200 + 3.0 * i, 150 + 2.0 * (i % 3)}, 50, 12});
    const Placement placement = place_labels(labels, page, {});
    EXPECT_TRUE(placement.is_clear);
    for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_LT(distance(labels[i], placement.boxes[i]), 80) << i;
}

TEST(LabelPlacement, ReportsALabelWithoutRoom) {
    const std::vector<Label> labels(6, {{20, 10}, 30, 12});
    const Placement placement = place_labels(labels, {0, 0, 40, 20}, {});
    EXPECT_FALSE(placement.is_clear);
    EXPECT_EQ(placement.boxes.size(), labels.size());
    PlaceSearch search;
    search.taken = {page};
    EXPECT_FALSE(place_labels({{{200, 150}, 40, 12}}, page, {}, search).is_clear);
}

// In such a low strip a label can only stand on the right, where the first label hides the second point.
TEST(LabelPlacement, ReportsALabelThatHidesAPoint) {
    const std::vector<Label> labels{{{20, 7}, 18, 12}, {{38, 7}, 10, 12}};
    const Placement placement = place_labels(labels, {0, 0, 60, 14}, {});
    EXPECT_FALSE(touch(placement.boxes[0], placement.boxes[1]));
    EXPECT_FALSE(placement.is_clear);
}

TEST(LabelPlacement, PutsALabelNearestToItsOwnPoint) {
    const std::vector<Label> labels{{{200, 150}, 40, 12}, {{214, 164}, 40, 12}};
    const Placement placement = place_labels(labels, page, {});
    EXPECT_LT(distance(labels[0], placement.boxes[0]), distance(labels[1], placement.boxes[0]));
    EXPECT_LT(distance(labels[1], placement.boxes[1]), distance(labels[0], placement.boxes[1]));
}

TEST(LabelPlacement, KeepsLabelsWithinTheAllowedDistance) {
    PlaceSearch search;
    search.farthest = 30;
    search.taken = {{150, 120, 260, 180}};
    const Placement near = place_labels({{{200, 150}, 40, 12}}, page, {}, search);
    EXPECT_FALSE(near.is_clear);
    search.farthest = 1e9;
    EXPECT_TRUE(place_labels({{{200, 150}, 40, 12}}, page, {}, search).is_clear);
}

TEST(LabelPlacement, IsTheSameEveryTime) {
    const std::vector<Label> labels = scattered(20, 3);
    const Placement one = place_labels(labels, page, {}), other = place_labels(labels, page, {});
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_EQ(one.boxes[i].left, other.boxes[i].left);
        EXPECT_EQ(one.boxes[i].top, other.boxes[i].top);
    }
}

TEST(NearestOn, IsTheSpotInTheBoxOrTheNearestOnItsEdge) {
    const Box box{10, 20, 30, 40};
    for (const auto& [from, to] : {std::pair{Spot{15, 25}, Spot{15, 25}},
                                   {Spot{0, 25}, Spot{10, 25}},
                                   {Spot{50, 50}, Spot{30, 40}},
                                   {Spot{20, 0}, Spot{20, 20}}}) {
        EXPECT_EQ(nearest_on(box, from).x, to.x);
        EXPECT_EQ(nearest_on(box, from).y, to.y);
    }
}

}  // namespace
}  // namespace harness::report
