#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "harness/source/scene/scene_literals.h"
#include "tests/harness/source/scene/handouts.h"

namespace harness::source {
namespace {

using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::SizeIs;
using testing::UnorderedElementsAre;

/// Another cylinder, whose caps are at y = 25 and y = 39; the sphere's radius is 24.
DecimalScene with_another_cylinder() {
    const auto decimal = [](int x) { return reference::Decimal::parse(std::to_string(x)).value(); };
    DecimalScene scene = scene_of_2024();
    scene.spheres.front().radius = decimal(24);
    scene.cylinders.front() = {{decimal(51), decimal(32), decimal(-53)}, decimal(5), decimal(14)};
    return scene;
}

std::set<std::string> located_in_2024(const std::string& source) {
    return located(source, scene_of_2024());
}

std::string rewritten_of_2024(const std::string& source) {
    return rewritten(source, scene_of_2024(), with_another_cylinder());
}

/// The same in a source that states the center and the height, too.
std::string rewritten_with_center(const std::string& source) {
    const std::string whole = rewritten_of_2024("vec3 cylCenter(2, 0, 0); float cylHeight = 4;\n" + source);
    const std::string begin = "vec3 cylCenter(51, 32, -53); float cylHeight = 14;\n";
    EXPECT_TRUE(whole.starts_with(begin)) << whole;
    return whole.substr(std::min(begin.size(), whole.size()));
}

TEST(FindCylinder, ReadsItsCenterInEverySpelling) {
    EXPECT_EQ(rewritten_with_center("vec3 cC = vec3(2.f, 0, 0);"), "vec3 cC = vec3(51.0f, 32, -53);");
    EXPECT_EQ(rewritten_with_center("cyl.center = {2, 0, 0};"), "cyl.center = {51, 32, -53};");
    EXPECT_EQ(rewritten_with_center("float cylX = 2, cylY = 0, cylZ = 0;"), "float cylX = 51, cylY = 32, cylZ = -53;");
    EXPECT_EQ(rewritten_with_center("#define CYL_CENTER vec3(2, 0, 0)\n"), "#define CYL_CENTER vec3(51, 32, (-53))\n");
}

TEST(FindCylinder, ReadsRadiusAndHeightByName) {
    EXPECT_EQ(rewritten_with_center("float cylinderRadius = 1, cyl_height = 4.0f;"),
              "float cylinderRadius = 5, cyl_height = 14.0f;");
    EXPECT_EQ(rewritten_with_center("cyl.radius = 1; cyl.h = 4; tube_r = 1;"),
              "cyl.radius = 5; cyl.h = 14; tube_r = 5;");
    EXPECT_EQ(rewritten_with_center("float cR = 1.f, height = 4;"), "float cR = 5.0f, height = 14;");
    EXPECT_EQ(rewritten_with_center("int H = 301, h = 4;"), "int H = 301, h = 14;")
        << "the window's height has another value";
}

TEST(FindCylinder, DistinguishesItsRadiusFromTheSpheres) {
    EXPECT_EQ(rewritten_of_2024("s.radius = 2; c.radius = 1;"), "s.radius = 24; c.radius = 5;");
    EXPECT_EQ(rewritten_of_2024("float R = 2, cylR = 1;"), "float R = 24, cylR = 5;");
    EXPECT_THAT(located_in_2024("float sphereRadius = 2; float cylRadius = 3;"), UnorderedElementsAre("radius"));
    EXPECT_THAT(located_in_2024("float sphereRadius = 3; float cylRadius = 1;"),
                UnorderedElementsAre("cylinder radius"));
    EXPECT_THAT(located_in_2024("float radius = 3;"), IsEmpty());
}

TEST(FindCylinder, ReadsRadiusAndHeightAfterTheCenter) {
    EXPECT_EQ(rewritten_of_2024("Cylinder c{vec3(2, 0, 0), 1, 4};"), "Cylinder c{vec3(51, 32, -53), 5, 14};");
    EXPECT_EQ(rewritten_of_2024("Cylinder c(2, 0, 0, 1, 4);"), "Cylinder c(51, 32, -53, 5, 14);");
    EXPECT_EQ(rewritten_of_2024("hit(S, V, vec3(2, 0, 0), 1, 4);"), "hit(S, V, vec3(51, 32, -53), 5, 14);");
    EXPECT_EQ(rewritten_with_center("vec4 p(2, 0, 0, 1); float h = 4;"), "vec4 p(51, 32, -53, 1); float h = 14;")
        << "homogeneous";
}

// A cap that stays where it is while the center moves would be another cylinder's.
TEST(FindCylinder, FindsTheCylinderOnlyTogetherWithItsHeight) {
    EXPECT_THAT(located_in_2024("vec3 cylCenter(2, 0, 0);"), IsEmpty()) << "the height may be within formulas";
    EXPECT_THAT(located_in_2024("float cylHeight = 4;"), IsEmpty()) << "where is the center?";
    const std::string whole = "vec3 cc(2, 0, 0); float cylHeight = 4; ";
    EXPECT_THAT(located_in_2024(whole), UnorderedElementsAre("cylinder center", "cylinder height"));
    for (const char* more : {"float halfHeight = 2;", "float cylHalf = 4 / 2;", "float cylH = 2.0;", "float yMax = 2;",
                             "float capBottom = -2;", "float cylTop = 3;", "vec3 topCap(2, 2, 0);"})
        EXPECT_THAT(located_in_2024(whole + more), IsEmpty()) << more;
    EXPECT_THAT(located_in_2024(whole + "float half = 2, top = 1;"), SizeIs(2)) << "of anything";
}

TEST(FindCylinder, LeavesTheWindowAlone) {
    EXPECT_THAT(located_in_2024("float top = 1, bottom = -1, clipTop = 2; int height = 301;"), IsEmpty());
    DecimalScene same = scene_of_2024();
    same.window.height = 4;
    EXPECT_THAT(located("vec3 cc(2, 0, 0); int h = 4;", same), IsEmpty()) << "the window's or the cylinder's";
    EXPECT_THAT(located("vec3 cc(2, 0, 0); int cylH = 4;", same), SizeIs(2));
}

TEST(FindCylinder, ConcludesNothingFromADoubtfulPlace) {
    EXPECT_THAT(located_in_2024("vec3 cc(2, 0, 0); float cylHeight = 4; double cyl_h = 5;"), IsEmpty());
    EXPECT_THAT(located_in_2024("float cylRadius = 1; double cyl_r = 2;"), IsEmpty());
    EXPECT_THAT(located_in_2024("vec3 cc(2, 0, 0);\n#ifdef OTHER\nfloat cylHeight = 4;\n#endif"), IsEmpty());
}

TEST(FindCylinder, FindsNoCylinderInASceneWithoutOne) {
    DecimalScene none = scene_of_2024();
    none.cylinders.clear();
    EXPECT_TRUE(find_scene("Cylinder c{vec3(2, 0, 0), 1, 4}; float cylHeight = 4;", none).located.empty());
}

}  // namespace
}  // namespace harness::source
