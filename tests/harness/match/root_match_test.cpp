#include <gtest/gtest.h>

#include <string>

#include "harness/match/match.h"
#include "tests/given/parsed.h"

namespace harness {
namespace {

TEST(Match, TakesTheFirstOfTwoNumberedRoots) {
    const std::string roots = "Question 6:\nt1 = 0.5\nt2 = 3.5\n";
    EXPECT_EQ(parsed_values(roots + "P_s = (1, 2, 3)"), "6.t: 0.5 @2\n6.hit: 1 2 3 @4\n");
    EXPECT_EQ(parsed_values(roots + "t: see below\n"), "6.t: 0.5 @2\n") << "no value is called so";
}

TEST(Match, PrefersTheChosenRootToTheOthers) {
    EXPECT_EQ(parsed_values("Question 6:\nt1 = 0.6\nt = 0.6\nt2 = 3.4\n"), "6.t: 0.6 @3\n");
}

TEST(Match, KnowsACoefficientByItsPowerOfT) {
    const std::string coefficients = "6.a: 1 @2\n6.b: -4 @3\n6.c: 2 @4\n6.d: 8 @5\n6.t: 0.5 @6\n";
    EXPECT_EQ(parsed_values("Question 6:\nCoefficient of t^2: 1\nCoefficient of t: -4\nConstant: 2\nd: 8\nt: 0.5\n"),
              coefficients);
    EXPECT_EQ(parsed_values("Question 6:\nt^2 coefficient: 1\nt coefficient: -4\nconstant term: 2\nd: 8\nt: 0.5\n"),
              coefficients);
}

TEST(Match, TakesWhereTheRayEntersForTheRoot) {
    const std::string root = "6.t: 0.5 @2\n";
    for (const char* line : {"t = 0.5\nThe ray leaves it at t = 3.5"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\n") + line + "\n"), root) << line;
    EXPECT_EQ(parsed_values("Question 6:\nenters at t = -0.5, leaves at t = 3.5\n"), "6.t: 3.5 @2\n")
        << "the eye is inside";
    EXPECT_EQ(parsed_values("Question 6:\nt = 3.5 is where it leaves\n"), "6.t: 3.5 @2\n")
        << "nothing else stands there";
}

TEST(Match, TakesTheRootThatIsChosenBySize) {
    EXPECT_EQ(parsed_values("Question 6:\nt = 0.5, t = 3.5; the larger is chosen\n"), "6.t: 3.5 @2\n");
}

TEST(Match, ReadsAPolynomialWithoutItsZero) {
    for (const char* line : {"Quadratic: 1 t^2 + -4 t + 2", "1t^2 + -4t + 2"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\n") + line + "\n"), "6.a: 1 @2\n6.b: -4 @2\n6.c: 2 @2\n")
            << line;
}

TEST(Match, TakesAVectorRForTheRightHandSideAndANumberForTheRadius) {
    EXPECT_EQ(parsed_values("Question 8:\nr: (1, 2, 1)\nt = 2\n"), "8.rhs: 1 2 1 @2\n8.t: 2 @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nr = 2\na = 1\n"), "6.a: 1 @3\n");
}

TEST(Match, TakesTheSizeOfANumberForNoAnswer) {
    EXPECT_EQ(parsed_values("Question 8:\nt: -2\nabs(t) = 2\n"), "8.t: -2 @2\n");
}

}  // namespace
}  // namespace harness
