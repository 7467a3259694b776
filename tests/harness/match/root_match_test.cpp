#include <gtest/gtest.h>

#include <string>

#include "harness/match/match.h"
#include "tests/given/parsed.h"

namespace harness {
namespace {

TEST(Match, TakesTheRootThatALineNames) {
    const std::string roots = "Question 6:\nt1 = 0.5\nt2 = 3.5\n";
    EXPECT_EQ(parsed_values(roots + "P_s = (1, 2, 3)"), "6.t: 0.5 @2\n6.hit: 1 2 3 @4\n");
    EXPECT_EQ(parsed_values(roots + "chosen: t2\nP_s = (1, 2, 3)"), "6.t: 3.5 @4\n6.hit: 1 2 3 @5\n");
    EXPECT_EQ(parsed_values(roots + "larger root: t2\nt = t2\n"), "6.t: 3.5 @5\n");
    EXPECT_EQ(parsed_values("Question 6:\nt+ = 3.5\nt- = 0.5\nt = t+\n"), "6.t: 3.5 @4\n");
    EXPECT_EQ(parsed_values(roots + "t: see below\n"), "6.t: 0.5 @2\n") << "no value is called so";
}

TEST(Match, TellsTheSignsOfRootsApart) {
    const std::string roots = "Question 6:\nt+ = 3.5\nt- = 0.5\n";
    EXPECT_EQ(parsed_values(roots + "smallest positive t = 9.5\n"), "6.t: 9.5 @4\n")
        << "what it says it is, though it is wrong";
    EXPECT_EQ(parsed_values("Question 6:\nt_near = 0.5\nt_far = 3.5\nWe choose t = 3.5\n"), "6.t: 3.5 @4\n");
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
    for (const char* line : {"The ray enters the sphere at t = 0.5 and leaves it at t = 3.5.",
                             "near t = 0.5, far t = 3.5", "entry t: 0.5, exit t: 3.5",
                             "t = 3.5 or t = 0.5, we use the smaller", "t = 0.5\nThe ray leaves it at t = 3.5",
                             "t = 0.5\n(t = 3.5 would be the exit point)", "t = 0.5\nt = 3.5 is the exit"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\n") + line + "\n"), root) << line;
    EXPECT_EQ(parsed_values("Question 6:\nt+ = 3.5, t- = 0.5\nsmaller: t-\n"), "6.t: 0.5 @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nenters at t = -0.5, leaves at t = 3.5\n"), "6.t: 3.5 @2\n")
        << "the eye is inside";
    EXPECT_EQ(parsed_values("Question 6:\nt = 3.5 is where it leaves\n"), "6.t: 3.5 @2\n")
        << "nothing else stands there";
    EXPECT_EQ(parsed_values("Question 6:\na = 1\nb = 2\nc = 3\nThe ray enters at (1, 2, 3) and exits at (4, 5, 6)\n"),
              "6.a: 1 @2\n6.b: 2 @3\n6.c: 3 @4\n6.hit: 1 2 3 @5\n");
}

TEST(Match, TakesTheRootThatIsChosenBySize) {
    const std::string roots = "Question 6:\nt1 = 0.5\nt2 = 3.5\n";
    EXPECT_EQ(parsed_values(roots + "using the larger root\n"), "6.t: 3.5 @4\n");
    EXPECT_EQ(parsed_values(roots + "the smaller one is taken\n"), "6.t: 0.5 @4\n");
    EXPECT_EQ(
        parsed_values("Question 6:\nRoots: t = 0.5 and t = 3.5\nBoth are positive. Choosing smaller root t = 0.5\n"),
        "6.t: 0.5 @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = 0.5, t = 3.5; the larger is chosen\n"), "6.t: 3.5 @2\n");
}

TEST(Match, ReadsAPolynomialWithoutItsZero) {
    for (const char* line : {"Quadratic: 1 t^2 + -4 t + 2", "1t^2 + -4t + 2"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\n") + line + "\n"), "6.a: 1 @2\n6.b: -4 @2\n6.c: 2 @2\n")
            << line;
}

TEST(Match, TakesANegatedNameBesideItsNameForNoAnswer) {
    EXPECT_EQ(parsed_values("Question 6:\nb = 6, -b = -6\nc = -7 (-c = 7)\n"), "6.b: 6 @2\n6.c: -7 @3\n");
    EXPECT_EQ(parsed_values("Question 5:\nV = (1, 0, 0), -V = (-1, 0, 0)\n"), "5.V: 1 0 0 @2\n");
}

TEST(Match, TakesTheNumberOfRootsForNoAnswer) {
    for (const char* line : {"d: 8 -> 2 roots", "d = 8 => 2 real solutions", "d: 8, 2 hits", "d: 8 so 2 roots"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\n") + line + "\n"), "6.d: 8 @2\n") << line;
    EXPECT_EQ(parsed_values("Question 6:\nd = 8, c = 2\n"), "6.c: 2 @2\n6.d: 8 @2\n");
}

TEST(Match, TakesAVectorRForTheRightHandSideAndANumberForTheRadius) {
    EXPECT_EQ(parsed_values("Question 8:\nr: (1, 2, 1)\nt = 2\n"), "8.rhs: 1 2 1 @2\n8.t: 2 @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nr = 2\na = 1\n"), "6.a: 1 @3\n");
}

TEST(Match, TakesRootsThatGoOnForNoCoefficient) {
    for (const char* roots : {"roots = 1.586 and 4.414", "Solutions: 1.586 and 4.414"})
        EXPECT_EQ(
            parsed_values(std::string("Question 6:\ncoefficients = 1.0, -6.0, 7.0\nd = 8\n") + roots + "\nt: 1.586\n"),
            "6.a: 1.0 @2\n6.b: -6.0 @2\n6.c: 7.0 @2\n6.d: 8 @3\n6.t: 1.586 @5\n")
            << roots;
}

TEST(Match, TakesTheRootThatIsRepeatedAsTheChosenOne) {
    for (const char* roots : {"t = 3.414 or t = 0.586", "t1 = 3.414, t2 = 0.586"}) {
        for (const char* choice : {"-> 0.586", "root chosen: 0.586", "smallest positive: 0.586", "final: 0.586",
                                   "smaller root is chosen: 0.586", "we pick 0.586", "selected root = 0.586"})
            EXPECT_EQ(parsed_values(fmt::format("Question 6:\n{}\n{}\n", roots, choice)), "6.t: 0.586 @3\n")
                << roots << " " << choice;
        EXPECT_EQ(parsed_values(fmt::format("Question 6:\n{}\nlargest positive: 3.414\n", roots)), "6.t: 3.414 @3\n")
            << roots;
    }
    EXPECT_EQ(parsed_values("Question 6:\nt1 = 3.414\nt2 = 0.586\nt2 is smaller and positive\n"), "6.t: 0.586 @4\n");
    EXPECT_EQ(
        parsed_values("Question 6:\nt0 = 3.414 (positive)\nt1 = 0.586 (positive)\nBoth are positive, use t1 = 0.586\n"),
        "6.t: 0.586 @4\n");
}

TEST(Match, TakesTheFirstOfTwoNumberedHitPoints) {
    EXPECT_EQ(
        parsed_values("Question 6:\nt1 = 0.586\nHit point 1: (0, 0, 1.414)\nt2 = 3.414\nHit point 2: (0, 0, -1.414)\n"),
        "6.t: 0.586 @2\n6.hit: 0 0 1.414 @3\n");
}

TEST(Match, TakesTheSizeOfANumberForNoAnswer) {
    for (const char* size : {"|t|: 2", "abs(t) = 2"})
        EXPECT_EQ(parsed_values(fmt::format("Question 8:\nt: -2\n{}\n", size)), "8.t: -2 @2\n") << size;
}

}  // namespace
}  // namespace harness
