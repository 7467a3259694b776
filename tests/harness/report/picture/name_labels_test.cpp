// The placing of names next to their points.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "harness/report/picture/panel.h"
#include "tests/given/report/drawn.h"

namespace harness::report::picture {
namespace {

/// Names of equal width at points more than 13 units apart, so that no mark lies on a different point's mark.
std::vector<Name> scattered(std::size_t count, const Box& box, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(box.left + 10, box.right - 10), y(box.top + 10, box.bottom - 10);
    std::vector<Name> names;
    while (names.size() < count) {
        const Spot at{std::round(x(random)), std::round(y(random))};
        bool is_free = true;
        for (const Name& name : names) is_free = is_free && std::hypot(name.at.x - at.x, name.at.y - at.y) > 13;
        if (is_free) names.push_back({at, fmt::format("N_{:02}", names.size())});
    }
    return names;
}

TEST(NamesInAPicture, StandBesideTheirOwnPointsOrAreJoinedToThem) {
    constexpr Box box{0, 0, 300, 200};
    std::size_t joined = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const std::vector<Name> names = scattered(25, box, seed);
        const std::string svg = place_names(names, box, {}, {}).svg;
        const auto texts = drawn::texts_in(svg);
        const auto leaders = drawn::leaders_in(svg);
        ASSERT_EQ(texts.size(), names.size()) << seed;
        for (std::size_t i = 0; i < names.size(); ++i) {
            EXPECT_EQ(texts[i].words, names[i].text);
            EXPECT_TRUE(drawn::belongs(texts[i], {names[i].at.x, names[i].at.y}, leaders)) << seed << ": " << i;
        }
        joined += leaders.size();
    }
    EXPECT_GT(joined, 5U) << "none was far enough to need a line";
}

TEST(NamesInAPicture, AreMergedIfTheyShareASpot) {
    const Names placed = place_names({{{50, 50}, "A"}, {{53, 50}, "P_s"}, {{90, 50}, "B"}}, {0, 0, 200, 100}, {}, {});
    EXPECT_TRUE(drawn::has_text(placed.svg, "A, P_s"));
    EXPECT_TRUE(drawn::has_text(placed.svg, "B"));
    EXPECT_EQ(drawn::texts_in(placed.svg).size(), 2U);
}

TEST(NamesInAPicture, OmitTheLastIfThereIsTooLittleRoom) {
    constexpr Box box{0, 0, 120, 80};
    const std::vector<Name> names = scattered(20, box, 5);
    const auto texts = drawn::texts_in(place_names(names, box, {}, {}).svg);
    EXPECT_LT(texts.size(), names.size());
    EXPECT_GE(texts.size(), 5U);
    for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(texts[i].words, names[i].text);
}

TEST(NamesInAPicture, AvoidTakenPlacesAndReserveTheirOwn) {
    constexpr Box box{0, 0, 200, 100};
    const std::vector<Name> first{{{60, 50}, "P_WCS"}}, second{{{66, 50}, "eye"}};
    const Names before = place_names(first, box, {}, {});
    const Names after = place_names(second, box, {}, before.taken);
    ASSERT_EQ(before.taken.size(), 2U) << "the name and its point's mark";
    ASSERT_EQ(after.taken.size(), 4U);
    const drawn::Text name = drawn::texts_in(before.svg).at(0), other = drawn::texts_in(after.svg).at(0);
    EXPECT_TRUE(name.right <= other.left || other.right <= name.left || name.bottom <= other.top ||
                other.bottom <= name.top);
}

}  // namespace
}  // namespace harness::report::picture
