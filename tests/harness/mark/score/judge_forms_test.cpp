// Other forms of the quadratic and the system are right, and what follows from them follows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "tests/given/printed_values.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"
#include "tests/harness/mark/score/handout_output.h"

namespace harness {
namespace {

using student::Program;
using student::Way;

TEST(Judge, AcceptsHalfBOnlyWithItsOwnDiscriminant) {
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "2"}}, reference::item::sphere::b), "right");
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "2"}}, reference::item::sphere::d), "right");
    EXPECT_EQ(accepted_with({{"b", "-2"}, {"d", "2"}}, reference::item::sphere::b),
              "the form with b' = b/2 and d' = b'^2 - ac");
    EXPECT_EQ(verdict_with({{"b", "-2"}}, reference::item::sphere::b), "wrong") << "d = 8 is that of b = -4";
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "-4"}}, reference::item::sphere::b), "wrong")
        << "the factor 2 is missing";
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "-4"}}, reference::item::sphere::d), "follow");
}

TEST(Judge, AcceptsNoDiscriminantOfHalfBForAWholeB) {
    EXPECT_EQ(verdict_with({{"c", "3"}, {"d", "13"}}, reference::item::sphere::d), "wrong") << "b is right as it is";
    EXPECT_EQ(verdict_with({{"c", "3"}, {"d", "4"}}, reference::item::sphere::d), "follow");
    // b follows from the corner of the pixel, in the full form.
    const auto mistake =
        std::ranges::find(student::named_mistakes(), "corner of the pixel", &student::NamedMistake::name);
    ASSERT_NE(mistake, student::named_mistakes().end());
    const student::Marking marking = student::handout_scene();
    const Program corner(marking.assignment, {}, mistake->mistake);
    const auto verdict_of = [&](float factor) {
        const auto coefficient = [&](const char* name) { return corner.scalar({reference::Subject::sphere, name}); };
        const float d = coefficient("b") * coefficient("b") - factor * coefficient("a") * coefficient("c");
        const Score score = mark(student::with_line(print(corner), 6, "d", fmt::format("{:f}", d)), marking);
        EXPECT_EQ(verdict_on(score, reference::item::sphere::b), "follow");
        return verdict_on(score, reference::item::sphere::d);
    };
    EXPECT_EQ(verdict_of(1), "wrong");
    EXPECT_EQ(verdict_of(4), "follow");
}

TEST(Judge, AcceptsAConsistentAnswerWithFewDecimals) {
    const auto mistake =
        std::ranges::find(student::named_mistakes(), "corner of the pixel", &student::NamedMistake::name);
    ASSERT_NE(mistake, student::named_mistakes().end());
    const student::Marking marking = student::handout_scene();
    const Program corner(marking.assignment, {}, mistake->mistake);
    const std::string output = student::with_line(print(corner), 8, "v", "0.251");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::triangle::v), "follow")
        << "its v is " << corner.scalar(reference::item::triangle::v) << ", the key's 0.25";
    EXPECT_EQ(verdict_with({{"v", "0.251"}}, reference::item::triangle::v), "wrong") << "with all others right";
}

TEST(Judge, AcceptsAQuadraticMultipliedAsAWhole) {
    const std::map<std::string, std::string> doubled = {{"a", "2"}, {"b", "-8"}, {"c", "4"}, {"d", "32"}};
    for (const char* name : {"a", "b", "c", "d", "t"})
        EXPECT_EQ(verdict_with(doubled, {reference::Subject::sphere, name}), "right") << name;
    EXPECT_EQ(verdict_with({{"a", "2"}, {"b", "-8"}, {"c", "4"}}, reference::item::sphere::d), "right")
        << "8 is still right by itself";
    EXPECT_EQ(verdict_with({{"a", "2"}, {"b", "-8"}}, reference::item::sphere::a), "wrong");
}

TEST(Judge, ReadsAVectorOfFour) {
    EXPECT_EQ(verdict_with({{"P_WCS", "vec4(0.000000, 0.000000, 2.000000, 1.000000)"}}, reference::item::P_WCS),
              "right");
    EXPECT_EQ(verdict_with({{"V", "vec4(0.000000, 0.000000, -1.000000, 0.000000)"}}, reference::item::V), "right");
    EXPECT_EQ(verdict_with({{"P_WCS", "vec4(0.000000, 0.000000, 2.000000, 3.000000)"}}, reference::item::P_WCS),
              "wrong");
}

TEST(Judge, AcceptsTheSystemWithRowsMultipliedOnBothSides) {
    const char* rows_doubled =
        "mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 8.000000, 0.000000), (-2.000000, 8.000000, 0.000000))";
    EXPECT_EQ(verdict_with({{"A", rows_doubled}, {"rhs", "vec3(0.000000, 4.000000, 0.000000)"}},
                           reference::item::triangle::matrix),
              "right");
    EXPECT_EQ(verdict_with({{"A", rows_doubled}, {"rhs", "vec3(0.000000, 4.000000, 0.000000)"}},
                           reference::item::triangle::rhs),
              "right");
    EXPECT_EQ(verdict_with({{"A", rows_doubled}}, reference::item::triangle::matrix), "wrong")
        << "the right-hand side is not doubled";
}

TEST(Judge, AcceptsTheSystemWithEitherSign) {
    const char* negated =
        "mat3x3((0.000000, 0.000000, -1.000000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const char* reordered =
        "mat3x3((-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000), (0.000000, 0.000000, -1.000000))";
    const char* negated_rhs = "vec3(0.000000, -2.000000, 0.000000)";
    for (const char* matrix : {negated, reordered}) {
        EXPECT_EQ(verdict_with({{"A", matrix}, {"rhs", negated_rhs}}, reference::item::triangle::matrix), "right");
        EXPECT_EQ(verdict_with({{"A", matrix}, {"rhs", negated_rhs}}, reference::item::triangle::rhs), "right");
        EXPECT_EQ(verdict_with({{"A", matrix}, {"rhs", ""}}, reference::item::triangle::matrix), "right") << "alone";
        EXPECT_EQ(verdict_with({{"A", matrix}}, reference::item::triangle::rhs), "wrong")
            << "not the sign of its matrix";
    }
    EXPECT_EQ(verdict_with({{"A", ""}, {"rhs", negated_rhs}}, reference::item::triangle::rhs), "right") << "alone";
    EXPECT_EQ(verdict_with({{"rhs", negated_rhs}}, reference::item::triangle::rhs), "wrong")
        << "not the sign of its matrix";
    EXPECT_EQ(accepted_with({{"A", reordered}, {"rhs", negated_rhs}}, reference::item::triangle::matrix),
              "columns in the order u, v, t, both sides multiplied by -1");
}

TEST(Judge, LetsASystemOfEitherSignFollow) {
    // V is (0, 0.6, -0.8) and P_WCS is (0, 1, 2) by mistake; A is (0, -2, 2).
    const std::map<std::string, std::string> own = {{"V", "vec3(0.000000, 0.600000, -0.800000)"},
                                                    {"P_WCS", "vec3(0.000000, 1.000000, 2.000000)"}};
    const auto verdict = [&](const std::string& matrix, const std::string& rhs, const reference::ItemId& id) {
        auto changed = own;
        changed["A"] = matrix;
        changed["rhs"] = rhs;
        return verdict_with(changed, id);
    };
    const char* matrix =
        "mat3x3((0.000000, -0.600000, 0.800000), (2.000000, 4.000000, 0.000000), (-2.000000, 4.000000, 0.000000))";
    const char* negated =
        "mat3x3((0.000000, 0.600000, -0.800000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const char* rhs = "vec3(0.000000, 3.000000, 0.000000)";
    const char* negated_rhs = "vec3(0.000000, -3.000000, 0.000000)";
    for (const reference::ItemId& id : {reference::item::triangle::matrix, reference::item::triangle::rhs}) {
        EXPECT_EQ(verdict(matrix, rhs, id), "follow");
        EXPECT_EQ(verdict(negated, negated_rhs, id), "follow");
    }
    EXPECT_EQ(verdict("", negated_rhs, reference::item::triangle::rhs), "follow") << "alone";
    EXPECT_EQ(verdict(matrix, negated_rhs, reference::item::triangle::rhs), "wrong") << "not the sign of its matrix";
}

TEST(Judge, SolvesTheStudentsOwnSystemOfEitherSign) {
    // The right-hand side should be (0, 2, 0) and is (0, 3, 0), with both sides multiplied by -1: u = v = 3/8.
    const char* negated =
        "mat3x3((0.000000, 0.000000, -1.000000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const std::map<std::string, std::string> own = {
        {"A", negated}, {"rhs", "vec3(0.000000, -3.000000, 0.000000)"}, {"u", "0.375"}, {"v", "0.375"}};
    EXPECT_EQ(verdict_with(own, reference::item::triangle::matrix), "right");
    EXPECT_EQ(verdict_with(own, reference::item::triangle::rhs), "wrong");
    EXPECT_EQ(verdict_with(own, reference::item::triangle::u), "follow");
    EXPECT_EQ(verdict_with(own, reference::item::triangle::v), "follow");
    // The column B - A should be (2, 4, 0) and is (3, 4, 0): u = 1/5 and v = 3/10.
    const char* wrong =
        "mat3x3((0.000000, 0.000000, -1.000000), (-3.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const std::map<std::string, std::string> other = {
        {"A", wrong}, {"rhs", "vec3(0.000000, -2.000000, 0.000000)"}, {"u", "0.2"}, {"v", "0.3"}};
    EXPECT_EQ(verdict_with(other, reference::item::triangle::matrix), "wrong");
    EXPECT_EQ(verdict_with(other, reference::item::triangle::u), "follow");
    EXPECT_EQ(verdict_with(other, reference::item::triangle::v), "follow");
}

TEST(Judge, SolvesTheStudentsOwnSystemWhoseSidesHaveOppositeSigns) {
    const char* matrix =
        "mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 4.000000, 0.000000), (-2.000000, 4.000000, 0.000000))";
    const char* negated =
        "mat3x3((0.000000, 0.000000, -1.000000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    for (const auto& [left, right] : {std::pair(matrix, "vec3(0.000000, -2.000000, 0.000000)"),
                                      std::pair(negated, "vec3(0.000000, 2.000000, 0.000000)")}) {
        const Score score = mark(handout_output({{"A", left}, {"rhs", right}, {"u", "-0.25"}, {"v", "-0.25"}}),
                                 student::handout_scene());
        EXPECT_EQ(verdict_on(score, reference::item::triangle::matrix), "right") << left;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::rhs), "wrong") << left;
        EXPECT_EQ(item_of(score, reference::item::triangle::rhs).diagnosis, "right-hand side negated") << left;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::u), "follow") << left;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::v), "follow") << left;
    }
}

TEST(Judge, DoesNotAcceptATransposedSystem) {
    EXPECT_EQ(verdict_with({{"A",
                             "mat3x3((0.000000, 2.000000, -2.000000), (0.000000, 4.000000, 4.000000), (1.000000, "
                             "0.000000, 0.000000))"}},
                           reference::item::triangle::matrix),
              "wrong");
}

TEST(Judge, AcceptsEveryPixelConventionOfTheRubricInEveryForm) {
    const student::Marking marking = student::off_axis_scene();
    Way grid;
    grid.convention = reference::PixelConvention::grid;
    grid.half_b = true;
    grid.columns = {2, 0, 1};
    const Score score = mark(print(Program(marking.assignment, grid)), marking);
    EXPECT_EQ(score.points, 100.0);
    EXPECT_EQ(item_of(score, reference::item::P_VCS).accepted_as, "the rubric accepts the grid pixel convention");
    Way corner;
    corner.convention = reference::PixelConvention::corner;
    const Score other = mark(print(Program(marking.assignment, corner)), marking);
    EXPECT_EQ(verdict_on(other, reference::item::P_VCS), "wrong");
    EXPECT_EQ(verdict_on(other, reference::item::P_WCS), "follow");
}

TEST(Judge, AcceptsMultipliedFormsInEveryPixelConvention) {
    const student::Marking marking = student::off_axis_scene();
    Way way;
    way.convention = reference::PixelConvention::grid;
    way.quadratic_factor = -2.5F;
    way.row_factors = {-1, 2, 0.5F};
    const Score score = mark(print(Program(marking.assignment, way)), marking);
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items)
            EXPECT_EQ(item.verdict, ItemVerdict::right) << question.number << item.spec.name << item.printed;
    }
}

}  // namespace
}  // namespace harness
