#include "harness/match/object_titles.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/given/parsed.h"

namespace harness {
namespace {

/// The objects of the printed values, by their first letters; "-" for none.
std::string objects_of(std::string_view output) {
    std::string letters;
    for (const auto& object : titled_objects(read_transcript(output, 10).sections.front()))
        letters += object ? to_string(*object).front() : '-';
    return letters;
}

TEST(TitledObjects, AreThoseOfTheTitleAbove) {
    EXPECT_EQ(
        objects_of("V = (0, 0, -1)\n--- Sphere ---\nt = 1\nnormal = (1, 0, 0)\nRay-triangle intersection:\nt = 2\n"),
        "-sst");
    EXPECT_EQ(objects_of("The Kugel:\nt = 1\nDas Dreieck\nt = 2\nKamera\nV = (0, 0, -1)\nSummary\nt = 1\n"), "st--");
}

TEST(TitledObjects, AreThoseOfTheirOwnRow) {
    EXPECT_EQ(objects_of("Sphere\nt = 1\nTriangle\nt = 2\nSphere: t = 1, P = (1, 0, 0)\nt = 2\n"), "stsst");
}

TEST(TitledObjects, AreNoneWithoutTitlesOfTwoObjects) {
    EXPECT_EQ(objects_of("Sphere\nt = 1\nnormal = (1, 0, 0)\n"), "");
    EXPECT_EQ(objects_of("the ray misses the sphere\nt = 1\nthe triangle is first\nt = 2\n"), "") << "sentences";
    EXPECT_EQ(objects_of("sphere t = 1\ntriangle t = 2\n"), "");
}

TEST(TitledObjects, DivideTheAnswersInAnyOrder) {
    const std::string camera = "X_vcs = (1, 0, 0)\nP_VCS = (0, 0, -2)\nV = (0, 0, -1)\n";
    const std::string sphere =
        "Sphere:\na = 1, b = -4, c = 2\nt = 0.59\nhit = (0, 0, 1.41)\nnormal = (-0.5, -0.5, 0.71)\n";
    const std::string triangle = "Triangle:\nt = 0, u = 0.25, v = 0.3\nhit = (0, 0, 2)\nnormal = (0, 0, 1)\n";
    EXPECT_EQ(parsed_values("Camera:\n" + camera + sphere + triangle),
              "1.P_VCS: 0 0 -2 @3\n2.X_vcs: 1 0 0 @2\n5.V: 0 0 -1 @4\n6.a: 1 @6\n6.b: -4 @6\n6.c: 2 @6\n6.t: 0.59 @7\n"
              "6.hit: 0 0 1.41 @8\n7.normal: -0.5 -0.5 0.71 @9\n8.t: 0 @11\n8.u: 0.25 @11\n8.v: 0.3 @11\n"
              "8.hit: 0 0 2 @12\n9.normal: 0 0 1 @13\n");
    EXPECT_EQ(parsed_values(triangle + sphere + "Winner: triangle (t = 0)\n"),
              "6.a: 1 @6\n6.b: -4 @6\n6.c: 2 @6\n6.t: 0.59 @7\n6.hit: 0 0 1.41 @8\n7.normal: -0.5 -0.5 0.71 @9\n"
              "8.t: 0 @2\n8.u: 0.25 @2\n8.v: 0.3 @2\n8.hit: 0 0 2 @3\n9.normal: 0 0 1 @4\n"
              "10.verdict: triangle first @10\n");
}

}  // namespace
}  // namespace harness
