#include "harness/read/verdict.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

using reference::Verdict;

std::optional<Verdict> verdict_of(const std::vector<std::string>& texts,
                                  VerdictPlace place = VerdictPlace::own_section) {
    std::vector<PrintedLine> lines;
    for (const std::string& text : texts) lines.push_back({text, 40 + static_cast<int>(lines.size())});
    const auto verdict = read_verdict(lines, place);
    return verdict ? std::optional(verdict->verdict) : std::nullopt;
}

TEST(ReadVerdict, IgnoresTheTextOfTheQuestion) {
    EXPECT_EQ(verdict_of({"Print triangle first or sphere first"}), std::nullopt);
    EXPECT_EQ(verdict_of({"Which is hit first, the sphere or the triangle?", "the sphere"}),
              Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"- ray hits triangle first", "- ray hits sphere first", "ray hits triangle first"}),
              Verdict(reference::Subject::triangle));
}

TEST(ReadVerdict, DoesWithoutARemarkInBrackets) {
    EXPECT_EQ(verdict_of({"ray hits triangle first (and the sphere not at all)"}),
              Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"Answer: the triangle."}), Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"(ray hits triangle first or sphere first)"}), std::nullopt);
}

TEST(ReadVerdict, TakesANegatedFirstAsTheOtherObject) {
    EXPECT_EQ(verdict_of({"ray does not hit triangle first, it hits sphere first"}),
              Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"ray does not hit the sphere first; it hits the triangle"}),
              Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"The triangle is no true hit, so ray hits sphere first"}),
              Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"The triangle is hit after the sphere"}), Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"Closest object: sphere (t = 2.1), triangle is behind it"}),
              Verdict(reference::Subject::sphere));
}

TEST(ReadVerdict, TellsThreeObjectsApart) {
    EXPECT_EQ(verdict_of({"ray hits cylinder first"}), Verdict(reference::Subject::cylinder));
    EXPECT_EQ(verdict_of({"cylinder"}), Verdict(reference::Subject::cylinder));
    EXPECT_EQ(verdict_of({"closest is the cylinder with t = 1"}), Verdict(reference::Subject::cylinder));
    EXPECT_EQ(verdict_of({"the order is cylinder (1), sphere (1.58579), triangle (2)"}),
              Verdict(reference::Subject::cylinder));
    EXPECT_EQ(verdict_of({"triangle, then cylinder, then sphere"}), Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"The cylinder is nearer than the sphere and the triangle"}),
              Verdict(reference::Subject::cylinder));
    EXPECT_EQ(verdict_of({"ray does not hit the cylinder first; it hits the sphere first"}),
              Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"ray hits triangle first / sphere first / cylinder first"}), std::nullopt) << "the question";
}

TEST(ReadVerdict, TakesTheObjectThatAnotherIsBehind) {
    EXPECT_EQ(verdict_of({"the triangle is behind the sphere"}), Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"the sphere is hit, the triangle is behind"}), Verdict(reference::Subject::sphere));
}

TEST(ReadVerdict, ReadsTheWordsStudentsUse) {
    EXPECT_EQ(verdict_of({"ray hits sphere first"}), Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"RAY HITS TRIANGLE FIRST!!!"}), Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"The first object hit is the triangle"}), Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"sphere is closer than the triangle"}), Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"triangle beats sphere"}), Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"Closest: triangle"}), Verdict(reference::Subject::triangle));
    EXPECT_EQ(verdict_of({"sphere"}), Verdict(reference::Subject::sphere));
    EXPECT_EQ(verdict_of({"The ray hits neither"}), Verdict::no_hit);
    EXPECT_EQ(verdict_of({"ray does not hit the sphere or the triangle"}), Verdict::no_hit);
    EXPECT_EQ(verdict_of({"it's a tie"}), Verdict::tie);
}

const Verdict sphere(reference::Subject::sphere);
const Verdict triangle(reference::Subject::triangle);
const Verdict cylinder(reference::Subject::cylinder);

TEST(ReadVerdict, ReadsWhatStandsBeforeOrBehindAllElse) {
    for (const char* line :
         {"The ray hits the triangle before anything else.", "Nothing is hit before the triangle.",
          "No object is closer than the triangle", "Everything else is behind the triangle",
          "The ray hits the triangle before it hits the cylinder or the sphere",
          "The ray hits the cylinder after the triangle, and the sphere last.",
          "the triangle occludes the other objects", "the triangle blocks the sphere",
          "the sphere is hidden by the triangle", "The sphere is farther away than the triangle",
          "sphere 1.2, triangle 0.9 -> triangle", "the sphere is not visible because the triangle hides it",
          "The sphere is occluded by the triangle"})
        EXPECT_EQ(verdict_of({line}), triangle) << line;
    EXPECT_EQ(verdict_of({"The cylinder is in front of the triangle and the sphere."}), cylinder);
    EXPECT_EQ(verdict_of({"The sphere is not closer than the triangle"}), triangle);
}

TEST(ReadVerdict, ReadsTheObjectThatIsNotDenied) {
    for (const char* line :
         {"The first thing to be hit is not the sphere but the triangle.",
          "The sphere is not hit first, the triangle is.", "not the sphere, but the triangle first",
          "The ray misses the sphere and the cylinder, so it hits the triangle", "not the sphere but the triangle",
          "The ray does not hit the sphere first, but the triangle."})
        EXPECT_EQ(verdict_of({line}), triangle) << line;
    EXPECT_EQ(verdict_of({"The sphere is not hit first"}), std::nullopt);
}

TEST(ReadVerdict, DeniesOnlyWhatTheNegationIsAbout) {
    for (const char* line :
         {"the ray misses the sphere and hits the triangle", "the sphere is missed and the triangle is hit",
          "The ray does not hit the sphere and hits the triangle",
          "The ray does not intersect the sphere and intersects the triangle",
          "misses the sphere then hits the triangle", "misses the sphere, then it hits the triangle",
          "no intersection with the sphere and an intersection with the triangle", "no sphere hit -> triangle",
          "no hit with sphere -> triangle", "not sphere -> triangle", "sphere missed => triangle",
          "Der Strahl verfehlt die Kugel und trifft das Dreieck", "kein Treffer der Kugel -> Dreieck"}) {
        EXPECT_EQ(verdict_of({line}), triangle) << line;
    }
    for (const char* line :
         {"the ray misses the sphere and the triangle", "The ray does not hit the sphere or the triangle",
          "the ray does not hit the sphere or touch the triangle",
          "no hit with the sphere and no hit with the triangle", "it neither hits the sphere nor hits the triangle"}) {
        EXPECT_EQ(verdict_of({line}), Verdict::no_hit) << line;
    }
}

TEST(ReadVerdict, ReadsWhatIsSaidYesTo) {
    EXPECT_EQ(verdict_of({"Is the sphere first? yes"}), sphere);
    EXPECT_EQ(verdict_of({"Triangle hit first? true"}), triangle);
    EXPECT_EQ(verdict_of({"Is the triangle first? no"}), std::nullopt) << "of three objects, another one may be";
    EXPECT_EQ(verdict_of({"Sphere or triangle first? yes"}), std::nullopt);
}

TEST(ReadVerdict, ReadsTheOrderOfTheObjects) {
    for (const char* line :
         {"triangle, cylinder, sphere", "triangle (0.99), cylinder (3.66), sphere (5.78)",
          "t_triangle < t_cylinder < t_sphere", "t_sphere > t_triangle", "sphere t > triangle t", "triangle -> sphere",
          "Sphere second, triangle first, cylinder third", "triangle then sphere"})
        EXPECT_EQ(verdict_of({line}), triangle) << line;
    for (const char* line : {"sphere and triangle", "sphere: hit, triangle: hit, cylinder: hit", "sphere or triangle",
                             "sphere, triangle and cylinder are objects"})
        EXPECT_EQ(verdict_of({line}), std::nullopt) << line;
}

TEST(ReadVerdict, ReadsThatNothingIsHit) {
    for (const char* line :
         {"ray hits nothing first", "winner=NULL", "first: none", "The ray doesn't hit anything.",
          "no object is hit first", "miss", "The ray misses the sphere, the triangle and the cylinder",
          "the sphere and the triangle are not hit", "neither the sphere nor the triangle is hit"})
        EXPECT_EQ(verdict_of({line}), Verdict::no_hit) << line;
}

TEST(ReadVerdict, ReadsOtherLanguagesAndWordsWithALetterWrong) {
    for (const char* line :
         {"Der Strahl trifft zuerst das Dreieck", "le rayon touche le triangle en premier",
          "El rayo toca primero el tri\u00e1ngulo", "il triangolo viene prima", "das Dreieck liegt vor der Kugel",
          "O raio atinge primeiro o tri\u00e2ngulo", "ray hits traingle first"})
        EXPECT_EQ(verdict_of({line}), triangle) << line;
    for (const char* line : {"le rayon ne touche rien", "El primero: ninguno", "Der Strahl trifft nichts"})
        EXPECT_EQ(verdict_of({line}), Verdict::no_hit) << line;
}

TEST(ReadVerdict, ReadsNothingFromAQuestionOrACondition) {
    for (const char* line :
         {"Is the sphere first?", "If the sphere is closer it is first", "Everything is before the sphere",
          "The triangle is hit after everything else", "the sphere is missed"})
        EXPECT_EQ(verdict_of({line}), std::nullopt) << line;
    EXPECT_EQ(verdict_of({"Which is hit first? The sphere."}), sphere);
}

TEST(ReadVerdict, PrefersTheSentenceToTheValues) {
    EXPECT_EQ(verdict_of({"sphere hit at t = 0.58", "ray hits triangle first", "triangle: hit, t = 0"}),
              Verdict(reference::Subject::triangle));
}

TEST(ReadVerdict, TakesTheMarkedRowOfATable) {
    EXPECT_EQ(verdict_of({"sphere    3.920", "triangle  2.833  <-- first", "cylinder  5.255"}), triangle);
    EXPECT_EQ(verdict_of({"sphere    3.920 <-- first", "triangle  2.833"}), sphere);
    EXPECT_EQ(verdict_of({"Triangle: 2.8331 (first hit)", "Sphere: 3.9195", "Cylinder: 5.2547"}), triangle);
    EXPECT_EQ(verdict_of({"nearest: triangle", "middle: sphere", "farthest: cylinder"}), triangle);
    EXPECT_EQ(verdict_of({"sphere: t = 3.920, first: no", "triangle: t = 2.833, first: yes",
                          "cylinder: t = 5.255, first: no"}),
              triangle);
    EXPECT_EQ(verdict_of({"sorted by t:", "  triangle (2.833)", "  sphere (3.920)"}), triangle);
    EXPECT_EQ(verdict_of({"sphere 3.920", "triangle 2.833"}), std::nullopt);
    EXPECT_EQ(verdict_of({"triangle 2.833"}), triangle);
}

TEST(ReadVerdict, TakesTheObjectThatALabelNamesFirst) {
    for (const char* line :
         {"sphere 3.92 | triangle 2.83 | cylinder 5.25 | first: triangle",
          "sphere: 3.92 cylinder: 5.25 first: triangle", "t_sphere=3.92 t_triangle=2.83 t_cylinder=5.25 first=triangle",
          "triangle 2.83 | sphere 3.92 | first hit: the triangle"})
        EXPECT_EQ(verdict_of({line}), triangle) << line;
    EXPECT_EQ(verdict_of({"cylinder 5.25 | triangle 2.83 | first: sphere"}), sphere);
    EXPECT_EQ(verdict_of({"The sphere is first: the triangle is behind it"}), sphere);
}

TEST(ReadVerdict, TakesNothingThatWouldBeForWhatIs) {
    EXPECT_EQ(verdict_of({"The triangle would be first, but the sphere is in front of it."}), sphere);
    EXPECT_EQ(verdict_of({"The triangle would be first, but the sphere is first"}), sphere);
}

TEST(ReadVerdict, ReadsWhatTheEyeSees) {
    for (const char* line : {"Das Auge sieht das Dreieck.", "El ojo ve el tri\u00e1ngulo", "You see the triangle",
                             "the pixel shows the triangle", "what we see is the triangle"})
        EXPECT_EQ(verdict_of({line}), triangle) << line;
}

TEST(ReadVerdict, TakesNoLaterPlaceForTheFirst) {
    EXPECT_EQ(verdict_of({"ray hits sphere first", "ray hits triangle second"}), sphere);
    EXPECT_EQ(verdict_of({"first: sphere", "second: triangle"}), sphere);
    EXPECT_EQ(verdict_of({"First hit: sphere", "Second hit: triangle"}), sphere);
    EXPECT_EQ(verdict_of({"Order along the ray:", "  1. sphere", "  2. triangle"}), sphere);
    EXPECT_EQ(verdict_of({"the ray hits the triangle second"}), std::nullopt);
    EXPECT_EQ(verdict_of({"The second object, the triangle, is hit first"}), triangle);
}

TEST(ReadVerdict, TakesAFlagOfZeroForFalse) {
    EXPECT_EQ(verdict_of({"sphereFirst = 0"}), verdict_of({"sphereFirst = false"}));
    EXPECT_NE(verdict_of({"hits sphere first: 0"}), sphere);
    EXPECT_EQ(verdict_of({"sphereFirst = 1"}), sphere);
    EXPECT_EQ(verdict_of({"sphere first, t = 0"}), sphere);
}

TEST(ReadVerdict, IgnoresDebugLines) {
    EXPECT_EQ(verdict_of({"DEBUG: sphere first"}), std::nullopt);
}

TEST(ReadVerdict, RequiresTheWordFirstOutsideQuestion10) {
    EXPECT_EQ(verdict_of({"the ray hits the sphere"}, VerdictPlace::elsewhere), std::nullopt);
    EXPECT_EQ(verdict_of({"ray hits sphere first"}, VerdictPlace::elsewhere), Verdict(reference::Subject::sphere));
}

TEST(ReadVerdict, GivesTheLineOfTheOutput) {
    EXPECT_EQ(read_verdict({{"", 7}, {"  ray hits sphere first", 8}}, VerdictPlace::own_section).value().line, 8);
    EXPECT_EQ(read_verdict({{"  * ray hits sphere first", 8}}, VerdictPlace::own_section).value().printed,
              "ray hits sphere first");
}

}  // namespace
}  // namespace harness
