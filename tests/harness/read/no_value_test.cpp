#include "harness/read/no_value.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

void expect_no_value(std::initializer_list<std::string_view> lines) {
    for (const std::string_view line : lines) EXPECT_TRUE(read_no_value(line)) << line;
}

void expect_nothing(std::initializer_list<std::string_view> lines) {
    for (const std::string_view line : lines) {
        const auto read = read_no_value(line);
        EXPECT_FALSE(read) << line << "\nread as: " << read.value_or(PrintedValue()).printed;
    }
}

TEST(ReadNoValue, ReadsWhatStandsInPlaceOfAValue) {
    expect_no_value({"t: none",
                     "hit point = no hit",
                     "N -> n/a",
                     "t is none",
                     "[t] none",
                     "t none",
                     "P_c (none)",
                     "t,none",
                     "t none; hit none",
                     "the normal does not exist",
                     "hit point is undefined",
                     "t has no value",
                     "t: {}",
                     "t: ---",
                     "t = no",
                     "smallest t: none",
                     "winner=NULL",
                     "No t",
                     "no normal",
                     "t: - (no hit)"});
}

TEST(ReadNoValue, ReadsThatNothingIsHit) {
    expect_no_value({"The ray misses the sphere",
                     "so there are no real roots",
                     "The cylinder is not hit by the ray.",
                     "cylinder not intersected",
                     "so we miss the sphere",
                     "we miss",
                     "Ray and sphere do not intersect",
                     "doesn't intersect",
                     "doesnt intersect",
                     "nothing hit",
                     "no sphere hit",
                     "The sphere isn't hit",
                     "complex roots",
                     "Discriminant is negative.",
                     "The ray never reaches the sphere",
                     "ray hits nothing",
                     "no hit (miss)",
                     "not hit, so no normal",
                     "no point of intersection",
                     "the ray fails to hit it",
                     "could not find an intersection"});
}

TEST(ReadNoValue, ReadsTheAnswerToAQuestion) {
    expect_no_value({"hit? no", "hit: no", "hit: false", "sphere: no", "Hits sphere? No", "isHit = false",
                     "sphereHit: no", "| hit | no |"});
    expect_nothing({"hit? yes", "hit: yes", "hit?", "no hit?", "sphere: yes"});
}

// Each of these has a negation or a word of missing, and says no such thing.
TEST(ReadNoValue, LeavesOtherDenialsAlone) {
    expect_nothing({"no normalization needed",
                    "check: no normalization needed",
                    "the sphere is hit, not missed",
                    "the ray never misses the sphere",
                    "no miss",
                    "The ray does not miss the sphere.",
                    "no hit with the caps",
                    "no second intersection",
                    "no hit before the eye",
                    "no closer hit",
                    "the hit point is not on the far side",
                    "the root is not an integer",
                    "not the smaller root",
                    "no negative roots",
                    "The discriminant is not negative",
                    "no problem so far",
                    "nothing to print",
                    "if the discriminant is negative there is no hit",
                    "t is none if d < 0",
                    "when d < 0 there is no hit",
                    "If d < 0: no hit",
                    "the ray passes through the cylinder",
                    "the sphere is hit",
                    "hit or miss",
                    "hit/miss",
                    "double root: no",
                    "Shadow: no",
                    "normalized? no",
                    "debug: false",
                    "The hit point is not rounded",
                    "no need to intersect the plane",
                    "not normalized yet",
                    "caps: none of them is nearer",
                    "the smaller root is negative, take the larger",
                    "there is no doubt: the sphere is hit",
                    "missing semicolon",
                    "done, no errors",
                    "Note: the normal is not flipped",
                    "no rounding of the hit point",
                    "the sphere, not the triangle, is hit",
                    "Results -",
                    "the sphere -",
                    "t - (3.5)"});
}

TEST(ReadNoValue, GivesTheLabel) {
    const auto label = [](std::string_view line) { return read_no_value(line).value_or(PrintedValue()).label; };
    EXPECT_EQ(label("t is none"), "t");
    EXPECT_EQ(label("[P_c] none"), "P_c");
    EXPECT_EQ(label("the normal does not exist"), "the normal");
    EXPECT_EQ(label("hit? no"), "hit");
    EXPECT_EQ(label("d = -91.5, t: none"), "t");
    EXPECT_EQ(label("The sphere is not hit"), "");
    EXPECT_EQ(label("Ray and sphere do not intersect"), "");
}

TEST(SaysNotAnswered, IsTrueForNothingElse) {
    EXPECT_TRUE(says_not_answered("not done"));
    EXPECT_TRUE(says_not_answered("  TODO"));
    EXPECT_FALSE(says_not_answered("not hit"));
    EXPECT_FALSE(says_not_answered("the loop is not done: t = 2"));
}

}  // namespace
}  // namespace harness
