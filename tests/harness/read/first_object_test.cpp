#include "harness/read/first_object.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

using reference::FirstObject;

std::optional<FirstObject> first_object_in(const std::vector<std::string>& texts,
                                           FirstObjectPlace place = FirstObjectPlace::own_section) {
    std::vector<PrintedLine> lines;
    for (const std::string& text : texts) lines.push_back({text, 40 + static_cast<int>(lines.size())});
    const auto first = read_first_object(lines, place);
    return first ? std::optional(first->object) : std::nullopt;
}

const FirstObject sphere(reference::Subject::sphere);
const FirstObject triangle(reference::Subject::triangle);
const FirstObject cylinder(reference::Subject::cylinder);

TEST(ReadFirstObject, ReadsTheWordsStudentsUse) {
    for (const char* line :
         {"ray hits triangle first", "RAY HITS TRIANGLE FIRST!!!", "The first object hit is the triangle",
          "Closest: triangle", "triangle", "Answer: the triangle.", "You see the triangle",
          "The first object that the ray intersects with is the triangle", "triangle is closer than the sphere",
          "ray hits triangle first (and the sphere not at all)", "triangle 2.833", "triangle, t = 0",
          "the triangle is before the sphere", "the sphere is behind the triangle",
          "the sphere is hidden by the triangle", "The sphere is farther away than the triangle",
          "Closest object: triangle (t = 2.1), sphere is behind it"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    EXPECT_EQ(first_object_in({"ray hits cylinder first"}), cylinder);
    EXPECT_EQ(first_object_in({"it's a tie"}), FirstObject::tie);
}

TEST(ReadFirstObject, TakesNoDeniedObject) {
    for (const char* line :
         {"ray does not hit sphere first, it hits triangle first",
          "The sphere is no true hit, so ray hits triangle first", "the ray misses the sphere and hits the triangle",
          "the sphere is missed and the triangle is hit", "The ray does not hit the sphere and hits the triangle",
          "misses the sphere, then it hits the triangle", "The sphere would be first, but the triangle is first"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    for (const char* line : {"The sphere is not hit first", "hits sphere first: 0", "sphereFirst = false",
                             "the ray hits the triangle second", "the sphere is missed",
                             "The triangle is hit after everything else", "not the triangle, because 0.5 < 0.586"})
        EXPECT_EQ(first_object_in({line}), std::nullopt) << line;
}

TEST(ReadFirstObject, ReadsThatNothingIsHit) {
    for (const char* line :
         {"ray hits nothing first", "winner=NULL", "first: none", "The ray doesn't hit anything.",
          "no object is hit first", "miss", "The ray hits neither", "the ray misses the sphere and the triangle",
          "The ray does not hit the sphere or the triangle", "neither the sphere nor the triangle is hit",
          "it neither hits the sphere nor hits the triangle", "The ray does not hit the sphere or touch the triangle"})
        EXPECT_EQ(first_object_in({line}), FirstObject::no_hit) << line;
    EXPECT_EQ(first_object_in({"top cap: none"}), std::nullopt) << "about a part";
}

TEST(ReadFirstObject, LeavesUnreadWhatStatesNothingOrSeveralThings) {
    for (const char* line :
         {"Print triangle first or sphere first", "Which is hit first, the sphere or the triangle?",
          "(ray hits triangle first or sphere first)", "ray hits triangle first / sphere first / cylinder first",
          "Is the sphere first?", "Is the triangle first? no", "If the sphere is closer it is first",
          "probably the sphere", "DEBUG: sphere first", "Everything is before the sphere", "sphere and triangle",
          "sphere: hit, triangle: hit, cylinder: hit", "sphere or triangle", "sphere (or the triangle)",
          "ray hits sphere first (or the triangle)", "testing object type sphere again",
          "the triangle's t is not the smaller one"})
        EXPECT_EQ(first_object_in({line}), std::nullopt) << line;
}

TEST(ReadFirstObject, LeavesComplicatedSentencesToOtherScenes) {
    for (const char* line : {"The sphere is not closer than the triangle", "Nothing is hit before the triangle.",
                             "not the sphere but the triangle", "Is the triangle first? yes"})
        EXPECT_EQ(first_object_in({line}), std::nullopt) << line;
}

TEST(ReadFirstObject, PrefersWhatIsCalledFirst) {
    EXPECT_EQ(first_object_in({"sphere hit at t = 0.58", "ray hits triangle first", "triangle: hit, t = 0"}), triangle);
    EXPECT_EQ(first_object_in({"sphere    3.920", "triangle  2.833  <-- first", "cylinder  5.255"}), triangle);
    EXPECT_EQ(first_object_in({"Triangle: 2.8331 (first hit)", "Sphere: 3.9195", "Cylinder: 5.2547"}), triangle);
    EXPECT_EQ(first_object_in({"nearest: triangle", "middle: sphere", "farthest: cylinder"}), triangle);
    EXPECT_EQ(first_object_in({"ray hits triangle first", "ray hits sphere second"}), triangle);
    EXPECT_EQ(first_object_in({"sphere: t = 3.920, first: no", "triangle: t = 2.833, first: yes"}), triangle);
    EXPECT_EQ(first_object_in({"--- The sphere ---", "ray hits triangle first"}), triangle);
    EXPECT_EQ(first_object_in({"cylinder 5.25 | sphere 3.92 | first: triangle"}), triangle);
}

TEST(ReadFirstObject, ReadsNothingFromLinesThatDiffer) {
    EXPECT_EQ(first_object_in({"ray hits triangle first", "ray hits sphere first"}), std::nullopt);
    EXPECT_EQ(first_object_in({"sphere 3.920", "triangle 2.833"}), std::nullopt);
    EXPECT_EQ(first_object_in({"1. cylinder t=1", "2. sphere t=1.58579"}), std::nullopt) << "it may not be sorted";
}

TEST(ReadFirstObject, RequiresTheWordFirstOutsideQuestion10) {
    EXPECT_EQ(first_object_in({"the ray hits the sphere"}, FirstObjectPlace::elsewhere), std::nullopt);
    EXPECT_EQ(first_object_in({"ray hits sphere first"}, FirstObjectPlace::elsewhere), sphere);
}

TEST(ReadFirstObject, GivesTheLineOfTheOutput) {
    const auto read = read_first_object({{"", 7}, {"  * ray hits sphere first", 8}}, FirstObjectPlace::own_section);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->line, 8);
    EXPECT_EQ(read->printed, "ray hits sphere first");
}

}  // namespace
}  // namespace harness
