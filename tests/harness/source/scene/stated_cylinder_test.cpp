// Which cylinder a source states, where it is not the assignment's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/source/scene/stated_scene.h"
#include "tests/harness/source/scene/handouts.h"

namespace harness::source {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> stated_beside_2024(const std::string& source) {
    return stated_parts(source, scene_of_2024());
}

TEST(StatedCylinder, IsTheAssignmentsInEverySpelling) {
    EXPECT_THAT(stated_beside_2024("Sphere s{{1, 0, 1}, 2}; Cylinder c{{2, 0, 0}, 1, 4};"), IsEmpty());
    EXPECT_THAT(stated_beside_2024(
                    "vec3 center(1, 0, 1); float R = 2; vec3 cylCenter(2, 0, 0); float radius = 1, cylHeight = 4;"),
                IsEmpty());
    EXPECT_THAT(stated_beside_2024("float halfHeight = 2, cyl_h = 2;"), IsEmpty());
    EXPECT_THAT(stated_beside_2024("vec3 cylNormal(0, 1, 0), cylTop(2, 2, 0);"), IsEmpty()) << "neither is its center";
}

TEST(StatedCylinder, HasThePartThatIsCopiedWrongly) {
    EXPECT_THAT(stated_beside_2024("vec3 cylCenter(2, 0, 1);"), ElementsAre("cylinder center = (2, 0, 1)"));
    EXPECT_THAT(stated_beside_2024("float cylinderRadius = 3;"), ElementsAre("cylinder radius = 3"));
    EXPECT_THAT(stated_beside_2024("float cyl_height = 5;"), ElementsAre("cylinder height = 5"));
    EXPECT_THAT(stated_beside_2024("float halfHeight = 3; int H = 301;"), ElementsAre("cylinder height = 6"));
    EXPECT_THAT(stated_beside_2024("const Cylinder cylinder{{2, 1, 0}, 1, 3};"),
                ElementsAre("cylinder center = (2, 1, 0)", "cylinder height = 3"));
}

TEST(StatedCylinder, IsToldFromSphereAndWindow) {
    EXPECT_THAT(stated_beside_2024("float R = 2, radius = 3;"), ElementsAre("cylinder radius = 3"));
    EXPECT_THAT(stated_beside_2024("float R = 3, radius = 1;"), ElementsAre("radius = 3"));
    EXPECT_THAT(stated_beside_2024("int H = 300; float cylHeight = 4;"), ElementsAre("H = 300"));
    EXPECT_THAT(stated_beside_2024("int H = 301; float height = 5;"), ElementsAre("cylinder height = 5"));
    EXPECT_THAT(stated_beside_2024("float top = 1, bottom = -1, cylTop = 2, cylBottom = -2;"), IsEmpty());
}

}  // namespace
}  // namespace harness::source
