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

namespace sphere = reference::item::sphere;
namespace triangle = reference::item::triangle;

/// A printed matrix of whole numbers, by columns.
std::string columns(const std::string& a, const std::string& b, const std::string& c) {
    return "mat3x3((" + a + "), (" + b + "), (" + c + "))";
}

using Changes = std::map<std::string, std::string>;

struct Form {
    const char* what;
    Changes printed;  ///< in place of the handout's answers
    std::vector<reference::ItemId> items;
    const char* verdict;
};

/// The handout's answers are a = 1, b = -4, c = 2, d = 8, the columns (0, 0, 1), (2, 4, 0), (-2, 4, 0), and (0, 2, 0)
/// for the right-hand side.
TEST(Judge, AcceptsEveryFormOfTheQuadraticAndOfTheSystem) {
    const Changes half_b = {{"b", "-2"}, {"d", "2"}}, doubled = {{"a", "2"}, {"b", "-8"}, {"c", "4"}, {"d", "32"}};
    const std::string negated = columns("0, 0, -1", "-2, -4, 0", "2, -4, 0"),
                      reordered = columns("-2, -4, 0", "2, -4, 0", "0, 0, -1"), negated_rhs = "vec3(0, -2, 0)",
                      rows_doubled = columns("0, 0, 1", "2, 8, 0", "-2, 8, 0");
    const std::vector<reference::ItemId> system = {triangle::matrix, triangle::rhs};
    // V is (0, 0.6, -0.8) and P_WCS is (0, 1, 2) by mistake; A is (0, -2, 2).
    const auto after_mistakes = [](const std::string& matrix, const std::string& rhs) {
        return Changes{{"V", "vec3(0, 0.6, -0.8)"}, {"P_WCS", "vec3(0, 1, 2)"}, {"A", matrix}, {"rhs", rhs}};
    };
    const std::string of_own = columns("0, -0.6, 0.8", "2, 4, 0", "-2, 4, 0"),
                      of_own_negated = columns("0, 0.6, -0.8", "-2, -4, 0", "2, -4, 0");
    const Form forms[] = {
        {"half b", half_b, {sphere::b, sphere::d}, "right"},
        {"d = 8 is that of b = -4", {{"b", "-2"}}, {sphere::b}, "wrong"},
        {"the factor 2 is missing", {{"b", "-2"}, {"d", "-4"}}, {sphere::b}, "wrong"},
        {"the factor 2 is missing", {{"b", "-2"}, {"d", "-4"}}, {sphere::d}, "follow"},
        {"doubled", doubled, {sphere::a, sphere::b, sphere::c, sphere::d, sphere::t}, "right"},
        {"8 is right by itself", {{"a", "2"}, {"b", "-8"}, {"c", "4"}}, {sphere::d}, "right"},
        {"c is not doubled", {{"a", "2"}, {"b", "-8"}}, {sphere::a}, "wrong"},
        {"a point's w", {{"P_WCS", "vec4(0, 0, 2, 1)"}}, {reference::item::P_WCS}, "right"},
        {"a direction's w", {{"V", "vec4(0, 0, -1, 0)"}}, {reference::item::V}, "right"},
        {"no point's w", {{"P_WCS", "vec4(0, 0, 2, 3)"}}, {reference::item::P_WCS}, "wrong"},
        {"rows doubled", {{"A", rows_doubled}, {"rhs", "vec3(0, 4, 0)"}}, system, "right"},
        {"the right-hand side is not doubled", {{"A", rows_doubled}}, {triangle::matrix}, "wrong"},
        {"negated", {{"A", negated}, {"rhs", negated_rhs}}, system, "right"},
        {"reordered", {{"A", reordered}, {"rhs", negated_rhs}}, system, "right"},
        {"alone", {{"A", negated}, {"rhs", ""}}, {triangle::matrix}, "right"},
        {"alone", {{"A", reordered}, {"rhs", ""}}, {triangle::matrix}, "right"},
        {"alone", {{"A", ""}, {"rhs", negated_rhs}}, {triangle::rhs}, "right"},
        {"not the sign of its matrix", {{"A", negated}}, {triangle::rhs}, "wrong"},
        {"not the sign of its matrix", {{"A", reordered}}, {triangle::rhs}, "wrong"},
        {"not the sign of its matrix", {{"rhs", negated_rhs}}, {triangle::rhs}, "wrong"},
        {"transposed", {{"A", columns("0, 2, -2", "0, 4, 4", "1, 0, 0")}}, {triangle::matrix}, "wrong"},
        {"follows", after_mistakes(of_own, "vec3(0, 3, 0)"), system, "follow"},
        {"follows negated", after_mistakes(of_own_negated, "vec3(0, -3, 0)"), system, "follow"},
        {"follows alone", after_mistakes("", "vec3(0, -3, 0)"), {triangle::rhs}, "follow"},
        {"follows in the other sign", after_mistakes(of_own, "vec3(0, -3, 0)"), {triangle::rhs}, "wrong"},
    };
    for (const auto& [what, printed, items, verdict] : forms) {
        for (const reference::ItemId& id : items)
            EXPECT_EQ(verdict_with(printed, id), verdict) << what << ": " << id.name;
    }
    EXPECT_EQ(accepted_with(half_b, sphere::b), "the form with b' = b/2 and d' = b'^2 - ac");
    EXPECT_EQ(accepted_with({{"A", reordered}, {"rhs", negated_rhs}}, triangle::matrix),
              "columns in the order u, v, t, both sides multiplied by -1");
}

/// By a right-hand side of (0, 3, 0), and by a column B - A of (3, 4, 0), both sides multiplied by -1.
TEST(Judge, SolvesTheStudentsOwnSystemOfEitherSign) {
    const Changes rhs = {{"A", columns("0, 0, -1", "-2, -4, 0", "2, -4, 0")},
                         {"rhs", "vec3(0, -3, 0)"},
                         {"u", "0.375"},
                         {"v", "0.375"}},
                  column = {{"A", columns("0, 0, -1", "-3, -4, 0", "2, -4, 0")},
                            {"rhs", "vec3(0, -2, 0)"},
                            {"u", "0.2"},
                            {"v", "0.3"}};
    EXPECT_EQ(verdict_with(rhs, triangle::matrix), "right");
    EXPECT_EQ(verdict_with(rhs, triangle::rhs), "wrong");
    EXPECT_EQ(verdict_with(column, triangle::matrix), "wrong");
    for (const Changes& own : {rhs, column}) {
        EXPECT_EQ(verdict_with(own, triangle::u), "follow");
        EXPECT_EQ(verdict_with(own, triangle::v), "follow");
    }
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
