// Where float can't give a number, its equations judge it. Every value here is worked by hand.
#include "harness/mark/diagnose/residual.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

namespace sphere = item::sphere;
namespace triangle = item::triangle;

/// The residual of an item among printed values, in the handout's scene: a sphere of radius 2 at (1, 1, 0), and a
/// triangle with A = (0, -2, 2), B - A = (2, 4, 0), C - A = (-2, 4, 0).
Residual residual(const ItemId& id, const std::vector<std::pair<ItemId, std::string>>& printed) {
    static const student::Marking marking = student::handout_scene();
    static const IntervalScene scene = real_scene(marking.assignment, marking.key.canonical);
    ItemTargets own;
    std::optional<MatchedItem> judged;
    for (const auto& [each, text] : printed) {
        const bool is_matrix = each == triangle::matrix || each == item::M_VCS_to_WCS;
        const MatchedItem value = printed_item(each, text, is_matrix ? MatrixOrder::rows : MatrixOrder::unsaid);
        own.set(each, own_value(value));
        if (each == id) judged = value;
    }
    return residual_of(judged.value(), own, scene);
}

TEST(Residual, OfASystemIsSmallForEverySolution) {
    // The second column is twice the third: t = 5 and 2u + v = 3.
    const auto of = [](const std::string& t, const std::string& u, const std::string& v) {
        return residual(triangle::t, {{triangle::matrix, "0 2 1  0 4 2  1 0 0"},
                                      {triangle::rhs, "3 6 5"},
                                      {triangle::t, t},
                                      {triangle::u, u},
                                      {triangle::v, v}});
    };
    EXPECT_EQ(of("5.0", "1.0", "1.0"), Residual::small);
    EXPECT_EQ(of("5.000000", "500000.000000", "-999997.000000"), Residual::small);
    EXPECT_EQ(of("5.0", "1.0", "2.0"), Residual::unknown) << "as Cramer's rule may leave it";
    EXPECT_EQ(of("6.0", "1.0", "1.0"), Residual::unknown);
}

TEST(Residual, OfASystemThatWasNotPrintedIsUnknown) {
    EXPECT_EQ(residual(triangle::u, {{triangle::t, "5"}, {triangle::u, "1"}, {triangle::v, "1"}}), Residual::unknown);
}

Residual of_hit(const std::string& hit) {
    return residual(triangle::hit, {{item::P_WCS, "1.000 2.000 3.000"},
                                    {item::V, "0.600 0.800 0.000"},
                                    {triangle::u, "0.250000"},
                                    {triangle::v, "0.500000"},
                                    {triangle::hit, hit}});
}

TEST(Residual, OfAHitPointIsSmallOnTheRayAndWhereUAndVPutIt) {
    EXPECT_EQ(of_hit("4.000000 6.000000 3.000000"), Residual::small) << "S + 5 V";
    EXPECT_EQ(of_hit("-2.0 -2.0 3.0"), Residual::small) << "S - 5 V";
    EXPECT_EQ(of_hit("-0.500000 1.000000 2.000000"), Residual::small) << "A + (B - A)/4 + (C - A)/2";
    EXPECT_EQ(of_hit("4.000000 6.000000 3.100000"), Residual::impossible);
    EXPECT_EQ(of_hit("-0.500000 1.000000 2.100000"), Residual::impossible);
}

TEST(Residual, OfAHitPointIsUnknownWithoutTheValuesThatTell) {
    EXPECT_EQ(residual(triangle::hit, {{item::P_WCS, "1 2 3"}, {item::V, "0.6 0.8 0"}, {triangle::hit, "9 9 9"}}),
              Residual::unknown)
        << "u and v are not printed";
    EXPECT_EQ(residual(triangle::hit, {{triangle::u, "0.25"}, {triangle::v, "0.5"}, {triangle::hit, "9 9 9"}}),
              Residual::unknown)
        << "the ray is not printed";
    EXPECT_EQ(residual(sphere::hit, {{item::V, "0.6 0.8 0"}, {sphere::hit, "9 9 9"}}), Residual::unknown);
}

TEST(Residual, OfAHitPointAllowsForTheRoundingsOfLargeCoordinates) {
    // Floats above 2^24 are 2 apart.
    const auto of = [](const std::string& x) {
        return residual(sphere::hit, {{item::P_WCS, "16777216.0 0.0 0.0"},
                                      {item::V, "0.000000 0.600000 0.800000"},
                                      {sphere::hit, x + " 3.0 4.0"}});
    };
    EXPECT_EQ(of("16777216.0"), Residual::small);
    EXPECT_EQ(of("16777218.0"), Residual::small) << "rounded once";
    EXPECT_EQ(of("16777316.0"), Residual::impossible) << "fifty units in the last place";
}

TEST(Residual, OfAnAxisIsARightAngleAndALength) {
    const auto of = [](const std::string& X, const std::string& Y) {
        return residual(item::X_vcs, {{item::X_vcs, X}, {item::Y_vcs, Y}});
    };
    EXPECT_EQ(of("0.6 0.8 0.0", "-0.8 0.6 0.0"), Residual::small);
    EXPECT_EQ(of("0.6 0.8 0.0", "-0.08 0.06 0.0"), Residual::small) << "Z x X, where Z and X are no right angle";
    EXPECT_EQ(of("-0.08 0.06 0.0", "0.6 0.8 0.0"), Residual::small);
    EXPECT_EQ(of("60 80 0", "-80 60 0"), Residual::small) << "columns of an inverse";
    EXPECT_EQ(of("0.6 0.8 0.0", "0.0 1.0 0.0"), Residual::impossible);
    EXPECT_EQ(of("0.00000006 0.00000008 0.0", "-0.00000008 0.00000006 0.0"), Residual::impossible) << "not normalized";
    EXPECT_EQ(residual(item::Y_vcs, {{item::X_vcs, "0.6 0.8 0"}, {item::Y_vcs, "0.0 1.0 0.0"}}), Residual::impossible);
    EXPECT_EQ(residual(item::X_vcs, {{item::X_vcs, "0.6 0.9 0"}}), Residual::unknown) << "Y is not printed";
}

TEST(Residual, OfTheViewsAxisIsItsLength) {
    EXPECT_EQ(residual(item::Z_vcs, {{item::Z_vcs, "0.6 0.0 0.8"}}), Residual::small);
    EXPECT_EQ(residual(item::Z_vcs, {{item::Z_vcs, "0.06 0.0 0.08"}}), Residual::impossible);
    EXPECT_EQ(residual(item::Z_vcs, {{item::Z_vcs, "6 0 8"}, {item::X_vcs, "8 0 6"}}), Residual::small);
    EXPECT_EQ(residual(item::Z_vcs, {{item::Z_vcs, "6 0 8"}, {item::X_vcs, "1 0 0"}}), Residual::impossible);
}

TEST(Residual, OfADirectionIsFromItsLengthOrTheMatrixTimesThePixel) {
    const std::pair<ItemId, std::string> M(item::M_VCS_to_WCS, "10 0 0 7  0 10 0 7  0 0 10 7  0 0 0 1");
    const std::pair<ItemId, std::string> pixel(item::P_VCS, "3.000 4.000 0.000");
    EXPECT_EQ(residual(item::V, {M, pixel, {item::V, "0.0 0.6 -0.8"}}), Residual::small);
    EXPECT_EQ(residual(item::V, {M, pixel, {item::V, "6.000 8.000 0.000"}}), Residual::small) << "10 (3, 4, 0)/5";
    EXPECT_EQ(residual(item::V, {M, pixel, {item::V, "6.100 8.000 0.000"}}), Residual::impossible);
    EXPECT_EQ(residual(item::V, {pixel, {item::V, "6.100 8.000 0.000"}}), Residual::unknown);
}

TEST(Residual, OfASpheresNormalIsItsDirectionFromTheOwnHitPoint) {
    const auto of = [](const std::string& hit, const std::string& normal) {
        return residual(sphere::normal, {{sphere::hit, hit}, {sphere::normal, normal}});
    };
    EXPECT_EQ(of("4.0 1.0 4.0", "0.6 0.0 0.8"), Residual::small) << "(3, 0, 4)/5";
    EXPECT_EQ(of("4.0 1.0 4.0", "1.5 0.0 2.0"), Residual::small) << "(3, 0, 4)/R";
    EXPECT_EQ(of("4.0 1.0 4.0", "-0.6 0.0 -0.8"), Residual::impossible);
    EXPECT_EQ(of("1.0 1.0 0.0", "0.6 0.0 0.8"), Residual::unknown) << "the hit point is the center";
    EXPECT_EQ(residual(sphere::normal, {{sphere::normal, "0.6 0.0 0.9"}}), Residual::unknown);
}

TEST(Residual, OfATrianglesNormalIsItsLengthAndTwoRightAngles) {
    const auto of = [](const std::string& normal) { return residual(triangle::normal, {{triangle::normal, normal}}); };
    EXPECT_EQ(of("0.0 0.0 1.0"), Residual::small);
    EXPECT_EQ(of("0.0 0.0 -1.0"), Residual::small);
    EXPECT_EQ(of("0.6 0.0 0.8"), Residual::unknown) << "as a cross product of edges that float can't tell apart may be";
    EXPECT_EQ(of("0.0 0.0 16.0"), Residual::impossible) << "not normalized";
    EXPECT_EQ(of("0.0 0.0 0.0"), Residual::impossible);
}

TEST(Residual, OfOtherItemsIsUnknown) {
    EXPECT_EQ(residual(item::P_WCS, {{item::P_WCS, "1 2 3"}}), Residual::unknown);
    EXPECT_EQ(residual(sphere::t, {{sphere::t, "1"}}), Residual::unknown);
}

}  // namespace
}  // namespace harness
