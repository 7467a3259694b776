#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "harness/match/match.h"
#include "tests/given/parsed.h"

namespace harness {
namespace {

TEST(Match, ReadsAnAnswerBelowWordsThatSomethingElseIsMissed) {
    const auto items = reference::asked_items(
        {{1, "", {reference::item::cylinder::t, reference::item::cylinder::hit, reference::item::cylinder::normal}}});
    for (const char* missed : {"end cap 1: no hit", "top disk: miss"}) {
        const std::string text = "Question 1\n" + std::string(missed) + "\nt = 1\nP = (1, 2, 3)\nwall = (4, 5, 6)\n";
        for (const MatchedItem& item : match(read_transcript(text, 1), items)) {
            ASSERT_TRUE(item.value);
            EXPECT_FALSE(item.value->numbers.empty()) << missed << ": " << item.spec.name;
        }
    }
}

TEST(Match, AppliesOneMissToAllItemsThatNeedTheHit) {
    EXPECT_EQ(parsed_values("Question 6:\nd = -1.0\nno real roots\nQuestion 7:\nno hit\n"),
              "6.d: -1.0 @2\n6.t: none @3\n6.hit: none @3\n7.normal: none @5\n");
}

TEST(Match, AppliesAMissToTheNormalThatIsAskedForElsewhere) {
    const std::string missed = "6.t: none @2\n6.hit: none @2\n7.normal: none @2\n";
    for (const char* normal : {"", "N = nan\n", "N = (nan, nan, nan)\n", "see question 6\n"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\nthe ray misses the sphere\nQuestion 7:\n") + normal), missed)
            << normal;
    EXPECT_EQ(parsed_values("Question 6:\nthe ray misses the sphere\n"), "6.t: none @2\n6.hit: none @2\n")
        << "not asked";
    EXPECT_EQ(parsed_values("Question 6:\nthe ray misses the sphere\nQuestion 7:\nN = (0, 0, 1)\n"),
              "6.t: none @2\n6.hit: none @2\n7.normal: 0 0 1 @4\n");
    EXPECT_EQ(parsed_values("Question 8:\nthe ray misses the triangle\nQuestion 9:\n"),
              parsed_values("Question 8:\nthe ray misses the triangle\n"))
        << "its plane has a normal";
}

TEST(Match, TakesMinusOneForNoHitWhereNoHitPointIsPrinted) {
    const std::string none = "6.t: none @2\n6.hit: none @2\n";
    EXPECT_EQ(parsed_values("Question 6:\nt = -1\n"), none);
    EXPECT_EQ(parsed_values("Question 6:\nt = -1.000\nP_s: none\n"), "6.t: none @2\n6.hit: none @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = inf\n"), none);
    EXPECT_EQ(parsed_values("Question 6:\nt = -1\nP_s = (1, 2, 3)\n"), "6.t: -1 @2\n6.hit: 1 2 3 @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = -2\n"), "6.t: -2 @2\n");
    EXPECT_EQ(parsed_values("Question 8:\nt = -1\n"), "8.t: -1 @2\n") << "the plane behind the start";
}

TEST(Match, TakesInfinityForNoHitAndNanOnlyWhereWordsSaySo) {
    const std::string none = "6.t: none @2\n6.hit: none @2\n";
    EXPECT_EQ(parsed_values("Question 6:\nt = inf\nP_s = (nan, inf, nan)\n"), none);
    EXPECT_EQ(parsed_values("Question 6:\nt = inf\nP_s = (1, 2, 3)\n"), "6.t: inf @2\n6.hit: 1 2 3 @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = nan (no hit)\n"), none);
    EXPECT_EQ(parsed_values("Question 6:\nt = nan\nP_s = (nan, nan, nan)\nno hit\n"), "6.t: none @4\n6.hit: none @4\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = nan\nP_s = (nan, nan, nan)\n"), "6.t: nan @2\n6.hit: nan nan nan @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = 0\nP_s = none\n"), "6.t: none @2\n6.hit: none @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = 0\n"), "6.t: 0 @2\n");
}

TEST(Match, TakesAFlagBelowTheParametersForAMiss) {
    const std::string values = "Question 8:\nt = 0\nu = 0.25\nv = 0.75\n",
                      read = "8.t: 0 @2\n8.u: 0.25 @3\n8.v: 0.75 @4\n";
    for (const char* flag : {"t > 0: false"})
        EXPECT_EQ(parsed_values(values + flag + "\n"), read + "8.hit: none @5\n") << flag;
    for (const char* flag : {"valid = 1", "t > 0: true", "valid = 0.5"})
        EXPECT_EQ(parsed_values(values + flag + "\n"), read) << flag;
    EXPECT_EQ(parsed_values(values + "t > 0: no\nP_t = (1, 2, 3)\n"), read + "8.hit: 1 2 3 @6\n")
        << "it is printed all the same";
}

TEST(Match, TakesNoOtherNumberForTWhereNothingIsHit) {
    EXPECT_EQ(parsed_values("Question 6:\na = 1, b = 2, c = 3\nsteps: 17\nd = -91.5, no hit\n"),
              "6.a: 1 @2\n6.b: 2 @2\n6.c: 3 @2\n6.d: -91.5 @4\n6.t: none @4\n6.hit: none @4\n");
}

TEST(Match, RejectsNegativeRootsWhereNothingIsHit) {
    const std::string none = "6.t: none @2\n6.hit: none @2\n";
    EXPECT_EQ(parsed_values("Question 6:\nt1 = -7.4, t2 = 4.6\nno hit\n"), "6.t: -7.4 @2\n6.hit: none @3\n");
    EXPECT_EQ(parsed_values("Question 6:\nt1 = -7.4, t2 = -4.6\n"), "6.t: -7.4 @2\n");
}

TEST(Match, TakesADashBehindATitleForDecoration) {
    EXPECT_EQ(parsed_values("Question 7:\nNormal -\n1 2 3\n"), "7.normal: 1 2 3 @3\n");
}

TEST(Match, TakesAMissOfAnotherObjectForNoneOfItsOwn) {
    EXPECT_EQ(parsed_values("Question 6:\nd = 91.5\nthe ray misses the triangle\n"), "6.d: 91.5 @2\n");
}

TEST(Match, TakesNoneOfSomethingElseForNoHit) {
    for (const char* line : {"errors: none", "warnings: none", "debug: no hit"})
        EXPECT_EQ(parsed_values("Question 6:\nd = 91.5\n" + std::string(line) + "\n"), "6.d: 91.5 @2\n") << line;
}

TEST(Match, TakesNoHitForTheTrianglesHitPointAlone) {
    EXPECT_EQ(parsed_values("Question 8:\nt = 1.5\nno hit\n"), "8.t: 1.5 @2\n8.hit: none @3\n");
}

TEST(Match, ReadsADashInATableForNoHit) {
    EXPECT_EQ(parsed_values("Question 6:\n| t   | -   |\n"), "6.t: none @2\n6.hit: none @2\n");
}

}  // namespace
}  // namespace harness
