#include "harness/read/line_reader.h"

#include <gtest/gtest.h>

#include "tests/harness/read/numbers.h"

namespace harness {
namespace {

Numbers numbers_of_line(std::string_view line) {
    return numbers_of(read_line(line).values);
}

PrintedValue only(std::string_view line) {
    const LineReading reading = read_line(line);
    EXPECT_EQ(reading.values.size(), 1U) << line;
    return reading.values.empty() ? PrintedValue{} : reading.values.front();
}

TEST(ReadLine, ReadsNoValueFromProse) {
    for (const std::string_view line :
         {"if there are 2 positive roots, pick the smaller one", "0 <= u <= 1", "a 3x3 linear system", "u + v <= 1",
          "(P - C) . (P - C) = R^2", "-------- ****", ""}) {
        EXPECT_EQ(numbers_of_line(line), Numbers{}) << line;
    }
}

TEST(ReadLine, ReadsAWholeNumberBehindANameAndAVerb) {
    EXPECT_EQ(numbers_of_line("d is 8 so there are two roots"), Numbers{8});
    EXPECT_EQ(numbers_of_line("The discriminant is 8. Two roots."), Numbers{8});
    EXPECT_EQ(numbers_of_line("a is 1 here"), Numbers{1});
    EXPECT_EQ(numbers_of_line("a is 1 and b is -4 and c is 2"), (Numbers{1, -4, 2}));
    EXPECT_EQ(numbers_of_line("there are 2 roots"), Numbers{});
}

TEST(ReadLine, ReadsAColonInPlaceOfTheFirstEquals) {
    EXPECT_EQ(numbers_of_line("d: 16 - 8 = 8"), Numbers{8});
    EXPECT_EQ(only("sphere: d = 8").label, "sphere: d");
    EXPECT_EQ(numbers_of_line("u: 1 + -1 = 0"), Numbers{0});
}

TEST(ReadLine, ReadsTheResultOfAFormula) {
    EXPECT_EQ(numbers_of_line("c = 5/3 = 1.66667"), Numbers{1.66667});
    EXPECT_EQ(numbers_of_line("t = 3 - sqrt2 = 1.5858"), Numbers{1.5858});
    EXPECT_EQ(numbers_of_line("t = 1/sqrt(2) = 0.707"), Numbers{0.707});
    EXPECT_EQ(numbers_of_line("d = b*b - 4*a*c = 8"), Numbers{8});
    EXPECT_EQ(numbers_of_line("d = 0.585786 = 2 - sqrt(2)"), Numbers{0.585786});
}

TEST(ReadLine, KeepsBothValuesWhereANameFollowsAnArrow) {
    const LineReading reading = read_line("P_VCS = (0, 0, -2) -> P_WCS = (0, 0, 2)");
    EXPECT_EQ(numbers_of(reading.values), (Numbers{0, 0, -2, 0, 0, 2}));
    ASSERT_EQ(reading.values.size(), 2U);
    EXPECT_EQ(reading.values[1].label, "P_WCS");
    EXPECT_EQ(numbers_of_line("d < 0 -> no hit"), Numbers{});
    EXPECT_EQ(numbers_of_line("P = (0, 0, 1) -> (2, 0, 1)"), (Numbers{2, 0, 1}));
}

TEST(ReadLine, ReadsWhatFollowsAQuadratic) {
    const LineReading reading = read_line("1t^2 + -4t + 2 = 0, disc 8; t = 0.585786");
    ASSERT_EQ(reading.values.size(), 5U);
    EXPECT_EQ(reading.values[2].label, "c");
    EXPECT_EQ(reading.values[3].label, "disc");
    EXPECT_EQ(reading.values[3].numbers.front().value, 8);
    EXPECT_EQ(reading.values[4].label, "t");
}

TEST(ReadLine, ReadsTheResultOfAFormulaWithNumbersPutIn) {
    const Numbers point{2, 0, 1};
    for (const std::string_view line :
         {"P_s = S + tV = (0, 0, 1) + 2 * (1, 0, 0) = (2, 0, 1)", "P_s = (0, 0, 1) + 2 (1, 0, 0) = (2, 0, 1)",
          "P_s: vec3(0, 0, 1) + 2.0 * vec3(1, 0, 0) = vec3(2, 0, 1)", "P_s = S + (1, 0, 0) * 2 = (2, 0, 1)",
          "P_s (0, 0, 1) + 2 * (1, 0, 0) = (2, 0, 1)"}) {
        EXPECT_EQ(numbers_of_line(line), point) << line;
        EXPECT_EQ(only(line).label.substr(0, 3), "P_s") << line;
    }
    for (const std::string_view line : {"b = 2 * (S - C).V = -13.46", "b = (-2)^2 - 4(1)(4.365) = -13.46"}) {
        EXPECT_EQ(numbers_of_line(line), Numbers{-13.46}) << line;
        EXPECT_EQ(only(line).label, "b") << line;
    }
}

TEST(ReadLine, ReadsTheResultOfDotProductsAndOfBracketsSideBySide) {
    for (const char* line : {"b = <V, V> = -4", "b = <S - C, S - C> - R^2 = -4", "b = 2(V, S - C) = -4"}) {
        EXPECT_EQ(numbers_of_line(line), Numbers{-4}) << line;
        EXPECT_EQ(read_line(line).values.front().label, "b") << line;
    }
    EXPECT_EQ(numbers_of_line("0 < u, v > 0 and t = 2"), Numbers{2});
    EXPECT_EQ(numbers_of_line("t = 2 P_s = (0, 0, 1)"), (Numbers{2, 0, 0, 1}));
}

TEST(ReadLine, LeavesOutACoefficient) {
    for (const char* line : {"b = 2(V.(S-C)) = -4", "b = 2h = -4", "b = 2 x -2 = -4", "b = 2(0*-1 + 0*-1 + -1*2) = -4"})
        EXPECT_EQ(numbers_of_line(line), Numbers{-4}) << line;
    EXPECT_EQ(numbers_of_line("d = 8 -> sqrt(d) = 2.83"), (Numbers{8, 2.83}));
}

TEST(ReadLine, TakesNoLabelForAFormula) {
    EXPECT_EQ(numbers_of_line("a = 1 (V has length 1). b = -4"), (Numbers{1, -4}));
    EXPECT_EQ(numbers_of_line("t = 2 P_s = S + tV = (2, 0, 1)"), (Numbers{2, 2, 0, 1}));
    EXPECT_EQ(numbers_of_line("u = 0 v = 1 u+v = 1"), (Numbers{0, 1, 1}));
    EXPECT_EQ(numbers_of_line("P: (1, 0, 0) - V: (0, 1, 0)"), (Numbers{1, 0, 0, 0, 1, 0}));
}

TEST(ReadLine, ReadsALoneFractionExactly) {
    const PrintedValue value = only("u = 1/4");
    EXPECT_EQ(value.numbers.at(0).value, 0.25);
    EXPECT_TRUE(value.numbers.at(0).exact);
}

TEST(ReadLine, KeepsTheValueOfAComparison) {
    EXPECT_EQ(numbers_of_line("t = 0.9 > 0 ok"), Numbers{0.9});
    EXPECT_EQ(numbers_of_line("u = 0.2, 0 <= u <= 1"), Numbers{0.2});
}

TEST(ReadLine, LeavesOutRemarks) {
    EXPECT_EQ(numbers_of_line("t = 0.333 (= 1/3)"), Numbers{0.333});
    EXPECT_EQ(numbers_of_line("a = 1 (a unit vector, so 1)"), Numbers{1});
}

TEST(ReadLine, ReadsNestingTypesAndBars) {
    const PrintedValue matrix = only("M = dmat3x3((1, 2, 3), (4, 5, 6), (7, 8, 9))");
    EXPECT_EQ(matrix.groups, 3);
    EXPECT_TRUE(matrix.typed);
    EXPECT_EQ(matrix.label, "M");
    EXPECT_EQ(only("[1 2 3; 4 5 6; 7 8 9]").groups, 3);
    EXPECT_EQ(only("[1; 2; 3]").groups, 1);
    EXPECT_EQ(only("[ 1 2 3 | 4 ]").bar_after, 3);
}

TEST(ReadLine, FindsLabelsBeforeAndAfterAValue) {
    EXPECT_EQ(only("P_s = S + t*V = (0, 0, 1)").label, "P_s");
    EXPECT_EQ(only("0.585786 <- t").after, "t");
    const LineReading reading = read_line("1 (a), -4 (b), 2 (c)");
    ASSERT_EQ(reading.values.size(), 3U);
    EXPECT_EQ(reading.values[2].after, "(c)");
}

TEST(ReadLine, NamesTheFirstComponentOfARecord) {
    for (const char* line :
         {"P = {x = 2", "P = Vec3 { x: 2", "P = Some(Vec3 { x: 2", "P = Optional[Vec3{x=2", "P = hit(Vec3{x=2"})
        EXPECT_EQ(only(line).label, "P x") << line;
}

TEST(ReadLine, SurvivesUnmatchedBrackets) {
    EXPECT_EQ(numbers_of_line("((((((1, 2, 3"), (Numbers{1, 2, 3}));
    EXPECT_EQ(numbers_of_line("1, 2, 3))))"), (Numbers{1, 2, 3}));
    EXPECT_EQ(numbers_of_line("(1, 2, 3] }"), (Numbers{1, 2, 3}));
}

TEST(ReadLine, ReadsTheValueBeforeWhatItIsWorkedOutFrom) {
    for (const char* line :
         {"P_WCS = (0, 0, -2)/|(0, 0, -2)| = (0, 0, 2)", "P_WCS = (0, 0, -2) / ||(0, 0, -2)|| = (0, 0, 2)"})
        EXPECT_EQ(numbers_of_line(line), (Numbers{0, 0, 2})) << line;
    EXPECT_EQ(numbers_of_line("d = 8 = b^2 - 4ac = 16 - 8"), Numbers{8});
}

TEST(ReadLine, ReadsTheResultOfProductsWithoutASign) {
    EXPECT_EQ(numbers_of_line("t = 2 (the smaller root), u = 0.25"), (Numbers{2, 0.25}));
}

}  // namespace
}  // namespace harness
