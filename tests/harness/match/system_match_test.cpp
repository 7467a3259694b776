#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "harness/match/match.h"
#include "tests/given/parsed.h"

namespace harness {
namespace {

TEST(Match, ReadsANumberBetweenItsBounds) {
    EXPECT_EQ(parsed_values(
                  "Question 8:\nt = 1\nu = 0.25\nv = 0.5\nSince 0 <= u <= 1, 0 <= v <= 1 and u + v = 0.75 <= 1, hit\n"),
              "8.t: 1 @2\n8.u: 0.25 @3\n8.v: 0.5 @4\n");
    EXPECT_EQ(parsed_values("Question 8:\nt = 1\nu = 0.25, 0 <= u <= 1\nv = 0.5\n"),
              "8.t: 1 @2\n8.u: 0.25 @3\n8.v: 0.5 @4\n");
}

TEST(Match, ReadsASolutionVectorAsTAndUAndV) {
    for (const char* name : {"sol", "x"})
        EXPECT_EQ(parsed_values(fmt::format("Question 8:\nrhs: (1, 2, 1)\n{}: vec3(2, 0.25, 0.5)\n", name)),
                  "8.rhs: 1 2 1 @2\n8.t: 2 @3\n8.u: 0.25 @3\n8.v: 0.5 @3\n")
            << name;
}

TEST(Match, TakesASumOfParametersForNeither) {
    EXPECT_EQ(parsed_values("Question 8:\nt = 1\nu = 0.5\nv = 0.25\nu + v = 0.75\n"),
              "8.t: 1 @2\n8.u: 0.5 @3\n8.v: 0.25 @4\n");
}

TEST(Match, ReadsNumbersBelowOneAnotherByTheirOrder) {
    EXPECT_EQ(parsed_values("Question 6:\na b c\n1\n-4\n2\n"), "6.a: 1 @3\n6.b: -4 @4\n6.c: 2 @5\n");
}

TEST(Match, TakesTheSystemBeforeItsElimination) {
    const std::string steps =
        "0 2 -2 1\n0 4 4 2\n1 0 0 3\n->\n1 0 0 3\n0 4 4 2\n0 2 -2 1\n->\n1 0 0 3\n0 4 4 2\n0 0 -4 0\nP_t: 0 0 2\n";
    for (const char* title :
         {"Gaussian elimination:", "Gaussian elimination, augmented matrix:", "System before elimination:"})
        EXPECT_EQ(parsed_values(fmt::format("Question 8:\n{}\n{}", title, steps)),
                  "8.matrix: (0 0 1) (2 4 0) (-2 4 0) by rows @3\n8.rhs: 1 2 3 @3\n8.hit: 0 0 2 @14\n")
            << title;
}

}  // namespace
}  // namespace harness
