#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "harness/match/match.h"
#include "tests/given/parsed.h"

namespace harness {
namespace {

TEST(Match, ReadsBarycentricCoordinatesBesideW) {
    EXPECT_EQ(parsed_values("Question 8:\n(w, u, v) = (0.5, 0.2, 0.3)\n"), "8.u: 0.2 @2\n8.v: 0.3 @2\n");
    EXPECT_EQ(parsed_values("Question 8:\n(u, v, w) = (0.2, 0.3, 0.5)\n"), "8.u: 0.2 @2\n8.v: 0.3 @2\n");
}

TEST(Match, ReadsBarycentricCoordinatesWithAThirdOne) {
    for (const char* line :
         {"(w, u, v): 0.25 0.25 0.5", "(u, v, w): 0.25 0.5 0.25", "Barycentric coordinates (u, v, w): 0.25 0.5 0.25",
          "barycentric (w, u, v) = (0.25, 0.25, 0.5)"})
        EXPECT_EQ(parsed_values(std::string("Question 8:\nt = 1\n") + line + "\n"),
                  "8.t: 1 @2\n8.u: 0.25 @3\n8.v: 0.5 @3\n")
            << line;
}

TEST(Match, ReadsANumberBetweenItsBounds) {
    EXPECT_EQ(parsed_values("Question 8:\nt = 1\n0 <= u = 0.25 <= 1\n0 <= v = 0.5 <= 1\nu + v = 0.75 <= 1\n"),
              "8.t: 1 @2\n8.u: 0.25 @3\n8.v: 0.5 @4\n");
    EXPECT_EQ(parsed_values(
                  "Question 8:\nt = 1\nu = 0.25\nv = 0.5\nSince 0 <= u <= 1, 0 <= v <= 1 and u + v = 0.75 <= 1, hit\n"),
              "8.t: 1 @2\n8.u: 0.25 @3\n8.v: 0.5 @4\n");
    EXPECT_EQ(parsed_values("Question 8:\nt = 1\nu = 0.25, 0 <= u <= 1\nv = 0.5\n"),
              "8.t: 1 @2\n8.u: 0.25 @3\n8.v: 0.5 @4\n");
}

TEST(Match, ReadsASolutionVectorAsTAndUAndV) {
    for (const char* name : {"solution", "Solution vector", "sol", "x"})
        EXPECT_EQ(parsed_values(fmt::format("Question 8:\nrhs: (1, 2, 1)\n{}: vec3(2, 0.25, 0.5)\n", name)),
                  "8.rhs: 1 2 1 @2\n8.t: 2 @3\n8.u: 0.25 @3\n8.v: 0.5 @3\n")
            << name;
}

TEST(Match, GivesOneNumberToTwoItemsThatAreSaidToBeEqual) {
    for (const char* line : {"u = v = 0.25", "u and v: 0.25", "u, v = 0.25"})
        EXPECT_EQ(parsed_values(std::string("Question 8:\n") + line + "\n"), "8.u: 0.25 @2\n8.v: 0.25 @2\n") << line;
    EXPECT_EQ(parsed_values("Question 8:\nt = 1\nu = 0.5\nv = 0.25\nu + v = 0.75\n"),
              "8.t: 1 @2\n8.u: 0.5 @3\n8.v: 0.25 @4\n");
}

TEST(Match, ReadsTheSolutionInTheOrderOfItsUnknowns) {
    const std::string solved = "8.t: 0.5 @{0}\n8.u: 0.25 @{0}\n8.v: 0.125 @{0}\n";
    for (const char* lines :
         {"x = (u, v, t) = 0.25 0.125 0.5", "The unknowns are u, v, t in this order.\nsolution: 0.25 0.125 0.5",
          "A has the columns B-A, C-A, -V\nx = (0.25, 0.125, 0.5)",
          "u(B-A) + v(C-A) - tV = S - A\nsolution: (0.25, 0.125, 0.5)"}) {
        const auto line = 2 + std::count(lines, lines + std::string_view(lines).size(), '\n');
        EXPECT_EQ(parsed_values(fmt::format("Question 8:\n{}\n", lines)), fmt::format(fmt::runtime(solved), line))
            << lines;
    }
    EXPECT_EQ(parsed_values("Question 8:\nrhs: 1 2 3\nsolution: 0.5 0.25 0.125\nbarycentric: alpha = 0.625, beta = "
                            "0.25, gamma = 0.125\nP_t = (0, 0, 2)\n"),
              "8.rhs: 1 2 3 @2\n8.t: 0.5 @3\n8.u: 0.25 @4\n8.v: 0.125 @4\n8.hit: 0 0 2 @5\n");
}

TEST(Match, ReadsNumbersBelowOneAnotherByTheirOrder) {
    EXPECT_EQ(
        parsed_values("Question 8:\n0 2 -2\n0 4 4\n1 0 0\n1\n2\n3\n0.5\n0.25\n0.125\n0 0 2\n"),
        "8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @2\n8.rhs: 1 2 3 @5\n8.t: 0.5 @8\n8.u: 0.25 @9\n8.v: 0.125 @10\n"
        "8.hit: 0 0 2 @11\n");
    EXPECT_EQ(
        parsed_values("Question 8:\na)\n0 2 -2\n0 4 4\n1 0 0\nb)\n1\n2\n3\nc)\n0.5\n0.25\n0.125\nd)\n0\n0\n2\n"),
        "8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @3\n8.rhs: 1 2 3 @7\n8.t: 0.5 @11\n8.u: 0.25 @12\n8.v: 0.125 @13\n"
        "8.hit: 0 0 2 @15\n");
    EXPECT_EQ(parsed_values("Question 6:\na b c\n1\n-4\n2\n"), "6.a: 1 @3\n6.b: -4 @3\n6.c: 2 @3\n");
    EXPECT_EQ(parsed_values("Question 3:\n1\n0\n0\n0\n0\n1\n0\n0\n0\n0\n1\n0\n0\n0\n4\n1\n"),
              "3.M_VCS_to_WCS: (1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 4 1) @2\n");
}

TEST(Match, TakesACornerForNoRightHandSide) {
    EXPECT_EQ(parsed_values("Question 8:\nA = (0, -2, 2)\nB = (2, 2, 2)\nC = (-2, 2, 2)\nS - A = (0, 2, 0)\n"),
              "8.rhs: 0 2 0 @5\n");
}

TEST(Match, TakesEdgesForNoRowsOfTheMatrixBelowThem) {
    EXPECT_EQ(parsed_values("Question 8:\nB - A: 2 4 0\nC - A: -2 4 0\nA: 0 2 -2\n 0 4 4\n 1 0 0\nrhs: 1 2 3\n"
                            "P_t: 0 0 2\n"),
              "8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @4\n8.rhs: 1 2 3 @7\n8.hit: 0 0 2 @8\n");
}

TEST(Match, TakesTheSystemBeforeItsElimination) {
    const std::string steps =
        "0 2 -2 1\n0 4 4 2\n1 0 0 3\n->\n1 0 0 3\n0 4 4 2\n0 2 -2 1\n->\n1 0 0 3\n0 4 4 2\n0 0 -4 0\nP_t: 0 0 2\n";
    for (const char* title :
         {"Gaussian elimination:", "Gaussian elimination, augmented matrix:", "System before elimination:"})
        EXPECT_EQ(parsed_values(fmt::format("Question 8:\n{}\n{}", title, steps)),
                  "8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @3\n8.rhs: 1 2 3 @3\n8.hit: 0 0 2 @14\n")
            << title;
    EXPECT_EQ(parsed_values("Question 8:\n0 2 -2 = 1\n0 4 4 = 2\n1 0 0 = 3\n"),
              "8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @2\n8.rhs: 1 2 3 @2\n");
}

}  // namespace
}  // namespace harness
