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

TEST(ReadFirstObject, IgnoresTheTextOfTheQuestion) {
    EXPECT_EQ(first_object_in({"Print triangle first or sphere first"}), std::nullopt);
    EXPECT_EQ(first_object_in({"Which is hit first, the sphere or the triangle?", "the sphere"}),
              FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"- ray hits triangle first", "- ray hits sphere first", "ray hits triangle first"}),
              FirstObject(reference::Subject::triangle));
}

TEST(ReadFirstObject, DoesWithoutARemarkInBrackets) {
    EXPECT_EQ(first_object_in({"ray hits triangle first (and the sphere not at all)"}),
              FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"Answer: the triangle."}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"(ray hits triangle first or sphere first)"}), std::nullopt);
    EXPECT_EQ(first_object_in({"The smaller t belongs to the triangle"}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"the triangle's t is not the smaller one"}), std::nullopt);
}

TEST(ReadFirstObject, TakesANegatedFirstAsTheOtherObject) {
    EXPECT_EQ(first_object_in({"ray does not hit triangle first, it hits sphere first"}),
              FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"ray does not hit the sphere first; it hits the triangle"}),
              FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"The triangle is no true hit, so ray hits sphere first"}),
              FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"The triangle is hit after the sphere"}), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"Closest object: sphere (t = 2.1), triangle is behind it"}),
              FirstObject(reference::Subject::sphere));
}

TEST(ReadFirstObject, TellsThreeObjectsApart) {
    EXPECT_EQ(first_object_in({"ray hits cylinder first"}), FirstObject(reference::Subject::cylinder));
    EXPECT_EQ(first_object_in({"cylinder"}), FirstObject(reference::Subject::cylinder));
    EXPECT_EQ(first_object_in({"closest is the cylinder with t = 1"}), FirstObject(reference::Subject::cylinder));
    EXPECT_EQ(first_object_in({"triangle, then cylinder, then sphere"}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"The cylinder is nearer than the sphere and the triangle"}),
              FirstObject(reference::Subject::cylinder));
    EXPECT_EQ(first_object_in({"ray does not hit the cylinder first; it hits the sphere first"}),
              FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"ray hits triangle first / sphere first / cylinder first"}), std::nullopt)
        << "the question";
}

TEST(ReadFirstObject, TakesTheObjectThatAnotherIsBehind) {
    EXPECT_EQ(first_object_in({"the triangle is behind the sphere"}), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"the sphere is hit, the triangle is behind"}), FirstObject(reference::Subject::sphere));
}

TEST(ReadFirstObject, ReadsTheWordsStudentsUse) {
    EXPECT_EQ(first_object_in({"ray hits sphere first"}), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"RAY HITS TRIANGLE FIRST!!!"}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"The first object hit is the triangle"}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"sphere is closer than the triangle"}), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"triangle beats sphere"}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"Closest: triangle"}), FirstObject(reference::Subject::triangle));
    EXPECT_EQ(first_object_in({"sphere"}), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"The ray hits neither"}), FirstObject::no_hit);
    EXPECT_EQ(first_object_in({"ray does not hit the sphere or the triangle"}), FirstObject::no_hit);
    EXPECT_EQ(first_object_in({"it's a tie"}), FirstObject::tie);
}

const FirstObject sphere(reference::Subject::sphere);
const FirstObject triangle(reference::Subject::triangle);
const FirstObject cylinder(reference::Subject::cylinder);

TEST(ReadFirstObject, ReadsWhatStandsBeforeOrBehindAllElse) {
    for (const char* line :
         {"The ray hits the triangle before anything else.", "Nothing is hit before the triangle.",
          "No object is closer than the triangle", "Everything else is behind the triangle",
          "The ray hits the triangle before it hits the cylinder or the sphere",
          "The ray hits the cylinder after the triangle, and the sphere last.",
          "the triangle occludes the other objects", "the triangle blocks the sphere",
          "the sphere is hidden by the triangle", "The sphere is farther away than the triangle",
          "the sphere is not visible because the triangle hides it", "The sphere is occluded by the triangle"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    EXPECT_EQ(first_object_in({"The cylinder is in front of the triangle and the sphere."}), cylinder);
    EXPECT_EQ(first_object_in({"The sphere is not closer than the triangle"}), triangle);
}

TEST(ReadFirstObject, ReadsTheObjectThatIsNotDenied) {
    for (const char* line :
         {"The first thing to be hit is not the sphere but the triangle.",
          "The sphere is not hit first, the triangle is.", "not the sphere, but the triangle first",
          "The ray misses the sphere and the cylinder, so it hits the triangle", "not the sphere but the triangle",
          "The ray does not hit the sphere first, but the triangle."})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    EXPECT_EQ(first_object_in({"The sphere is not hit first"}), std::nullopt);
}

TEST(ReadFirstObject, DeniesOnlyWhatTheNegationIsAbout) {
    for (const char* line :
         {"the ray misses the sphere and hits the triangle", "the sphere is missed and the triangle is hit",
          "The ray does not hit the sphere and hits the triangle",
          "The ray does not intersect the sphere and intersects the triangle",
          "misses the sphere then hits the triangle", "misses the sphere, then it hits the triangle",
          "no intersection with the sphere and an intersection with the triangle", "no sphere hit -> triangle",
          "no hit with sphere -> triangle", "not sphere -> triangle", "sphere missed => triangle"}) {
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    }
    for (const char* line :
         {"the ray misses the sphere and the triangle", "The ray does not hit the sphere or the triangle",
          "the ray does not hit the sphere or touch the triangle",
          "no hit with the sphere and no hit with the triangle", "it neither hits the sphere nor hits the triangle"}) {
        EXPECT_EQ(first_object_in({line}), FirstObject::no_hit) << line;
    }
}

TEST(ReadFirstObject, ReadsWhatIsSaidYesTo) {
    EXPECT_EQ(first_object_in({"Is the sphere first? yes"}), sphere);
    EXPECT_EQ(first_object_in({"Triangle hit first? true"}), triangle);
    EXPECT_EQ(first_object_in({"Is the triangle first? no"}), std::nullopt) << "of three objects, another one may be";
    EXPECT_EQ(first_object_in({"Sphere or triangle first? yes"}), std::nullopt);
}

TEST(ReadFirstObject, ReadsTheOrderOfTheObjects) {
    for (const char* line : {"t_triangle < t_cylinder < t_sphere", "Sphere second, triangle first, cylinder third",
                             "triangle then sphere"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    for (const char* line : {"sphere and triangle", "sphere: hit, triangle: hit, cylinder: hit", "sphere or triangle",
                             "sphere, triangle and cylinder are objects"})
        EXPECT_EQ(first_object_in({line}), std::nullopt) << line;
}

TEST(ReadFirstObject, ReadsThatNothingIsHit) {
    for (const char* line :
         {"ray hits nothing first", "winner=NULL", "first: none", "The ray doesn't hit anything.",
          "no object is hit first", "miss", "The ray misses the sphere, the triangle and the cylinder",
          "the sphere and the triangle are not hit", "neither the sphere nor the triangle is hit"})
        EXPECT_EQ(first_object_in({line}), FirstObject::no_hit) << line;
}

TEST(ReadFirstObject, ReadsNothingFromAQuestionOrACondition) {
    for (const char* line :
         {"Is the sphere first?", "If the sphere is closer it is first", "Everything is before the sphere",
          "The triangle is hit after everything else", "the sphere is missed"})
        EXPECT_EQ(first_object_in({line}), std::nullopt) << line;
    EXPECT_EQ(first_object_in({"Which is hit first? The sphere."}), sphere);
}

TEST(ReadFirstObject, PrefersTheSentenceToTheValues) {
    EXPECT_EQ(first_object_in({"sphere hit at t = 0.58", "ray hits triangle first", "triangle: hit, t = 0"}),
              FirstObject(reference::Subject::triangle));
}

TEST(ReadFirstObject, TakesTheMarkedRowOfATable) {
    EXPECT_EQ(first_object_in({"sphere    3.920", "triangle  2.833  <-- first", "cylinder  5.255"}), triangle);
    EXPECT_EQ(first_object_in({"sphere    3.920 <-- first", "triangle  2.833"}), sphere);
    EXPECT_EQ(first_object_in({"Triangle: 2.8331 (first hit)", "Sphere: 3.9195", "Cylinder: 5.2547"}), triangle);
    EXPECT_EQ(first_object_in({"nearest: triangle", "middle: sphere", "farthest: cylinder"}), triangle);
    EXPECT_EQ(first_object_in({"sphere: t = 3.920, first: no", "triangle: t = 2.833, first: yes",
                               "cylinder: t = 5.255, first: no"}),
              triangle);
    EXPECT_EQ(first_object_in({"sphere 3.920", "triangle 2.833"}), std::nullopt);
    EXPECT_EQ(first_object_in({"triangle 2.833"}), triangle);
}

TEST(ReadFirstObject, ReadsAnObjectWithItsReason) {
    for (const char* line : {"The triangle, because 0.000 < 0.586.", "triangle because t_t < t_s",
                             "triangle since 0 < 0.586", "triangle at t = 0", "triangle, t = 0"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    EXPECT_EQ(first_object_in({"sphere, t = 3.92", "triangle, t = 2.83"}), std::nullopt) << "rows of a table";
    EXPECT_EQ(first_object_in({"not the triangle, because 0.5 < 0.586"}), std::nullopt);
    EXPECT_EQ(first_object_in({"first hit: triangle at t = 0.5", "Sphere (from question 6): t = 0.58"}), triangle);
}

TEST(ReadFirstObject, ReadsAnObjectBeforeAReasonThatNamesOthers) {
    EXPECT_EQ(first_object_in({"the triangle, which is behind the sphere"}), FirstObject(reference::Subject::sphere));
    EXPECT_EQ(first_object_in({"the triangle and the sphere, which are at t = 0"}), std::nullopt);
}

TEST(ReadFirstObject, TakesTheObjectThatALabelNamesFirst) {
    for (const char* line :
         {"sphere 3.92 | triangle 2.83 | cylinder 5.25 | first: triangle",
          "sphere: 3.92 cylinder: 5.25 first: triangle", "t_sphere=3.92 t_triangle=2.83 t_cylinder=5.25 first=triangle",
          "triangle 2.83 | sphere 3.92 | first hit: the triangle"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
    EXPECT_EQ(first_object_in({"cylinder 5.25 | triangle 2.83 | first: sphere"}), sphere);
    EXPECT_EQ(first_object_in({"The sphere is first: the triangle is behind it"}), sphere);
}

TEST(ReadFirstObject, TakesNothingThatWouldBeForWhatIs) {
    EXPECT_EQ(first_object_in({"The triangle would be first, but the sphere is first"}), sphere);
}

TEST(ReadFirstObject, ReadsWhatTheEyeSees) {
    for (const char* line : {"You see the triangle", "the pixel shows the triangle", "what we see is the triangle"})
        EXPECT_EQ(first_object_in({line}), triangle) << line;
}

TEST(ReadFirstObject, TakesNoLaterPlaceForTheFirst) {
    EXPECT_EQ(first_object_in({"ray hits sphere first", "ray hits triangle second"}), sphere);
    EXPECT_EQ(first_object_in({"first: sphere", "second: triangle"}), sphere);
    EXPECT_EQ(first_object_in({"First hit: sphere", "Second hit: triangle"}), sphere);
    EXPECT_EQ(first_object_in({"Order along the ray:", "  1. sphere", "  2. triangle"}), sphere);
    EXPECT_EQ(first_object_in({"the ray hits the triangle second"}), std::nullopt);
    EXPECT_EQ(first_object_in({"The second object, the triangle, is hit first"}), triangle);
}

TEST(ReadFirstObject, TakesAFlagOfZeroForFalse) {
    EXPECT_EQ(first_object_in({"sphereFirst = 0"}), first_object_in({"sphereFirst = false"}));
    EXPECT_NE(first_object_in({"hits sphere first: 0"}), sphere);
    EXPECT_EQ(first_object_in({"sphereFirst = 1"}), sphere);
    EXPECT_EQ(first_object_in({"sphere first, t = 0"}), sphere);
}

TEST(ReadFirstObject, IgnoresDebugLines) {
    EXPECT_EQ(first_object_in({"DEBUG: sphere first"}), std::nullopt);
}

TEST(ReadFirstObject, RequiresTheWordFirstOutsideQuestion10) {
    EXPECT_EQ(first_object_in({"the ray hits the sphere"}, FirstObjectPlace::elsewhere), std::nullopt);
    EXPECT_EQ(first_object_in({"ray hits sphere first"}, FirstObjectPlace::elsewhere),
              FirstObject(reference::Subject::sphere));
}

TEST(ReadFirstObject, GivesTheLineOfTheOutput) {
    EXPECT_EQ(read_first_object({{"", 7}, {"  ray hits sphere first", 8}}, FirstObjectPlace::own_section).value().line,
              8);
    EXPECT_EQ(read_first_object({{"  * ray hits sphere first", 8}}, FirstObjectPlace::own_section).value().printed,
              "ray hits sphere first");
}

TEST(ReadFirstObject, TakesNoNumberedListForASortedOne) {
    const std::vector<std::string> list = {"1. cylinder t=1", "2. sphere t=1.58579", "3. triangle t=2"};
    EXPECT_EQ(first_object_in(list), std::nullopt) << "it may not be sorted";
    EXPECT_EQ(first_object_in({"The first object that the ray intersects with is the triangle"}),
              FirstObject(reference::Subject::triangle));
}

TEST(ReadFirstObject, ReadsTheFieldOfARecord) {
    for (const char* text : {"HitResult { object: Cylinder, distance: 1 }", "Hit { kind: Cylinder, t: 1 }"})
        EXPECT_EQ(first_object_in({text}), FirstObject(reference::Subject::cylinder)) << text;
    EXPECT_EQ(first_object_in({"now the sphere and its normal", "testing object type sphere again"}), std::nullopt);
}

}  // namespace
}  // namespace harness
