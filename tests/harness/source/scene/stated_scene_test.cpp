#include "harness/source/scene/stated_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/source/scene/handouts.h"

namespace harness::source {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> stated_beside_2021(const std::string& source) {
    return stated_parts(source, scene_of_2021());
}

TEST(StatedScene, IsEmptyIfTheSourceStatesTheAssignments) {
    EXPECT_THAT(stated_beside_2021("vec3 eye(0, 0, 4), center(1, 1, 0); float R = 2; int W = 301;"), IsEmpty());
    EXPECT_THAT(stated_beside_2021("vec3 color(3, 1, 4); float epsilon = 0.001f;"), IsEmpty());
}

TEST(StatedScene, HasThePartThatIsCopiedWrongly) {
    EXPECT_THAT(stated_beside_2021("vec3 eye(0, 0, 4); vec3 center(1, 1, 1);"), ElementsAre("center = (1, 1, 1)"));
    EXPECT_THAT(stated_beside_2021("glm::vec3 lookAt = glm::vec3(0, 0, 1);"), ElementsAre("lookat = (0, 0, 1)"));
    EXPECT_THAT(stated_beside_2021("const float radius = 3.0f;"), ElementsAre("radius = 3"));
    EXPECT_THAT(stated_beside_2021("vec3 A(0,-2,2), B(2,2,2), C(-2,2,3);"), ElementsAre("C = (-2, 2, 3)"));
    EXPECT_THAT(stated_beside_2021("float clipNear = 1; int W = 300;"), ElementsAre("clipNear = 1", "W = 300"));
}

TEST(StatedScene, KnowsPartsByTheirPlace) {
    EXPECT_THAT(stated_beside_2021("const Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}};"),
                ElementsAre("eye = (0, 0, 5)"));
    EXPECT_THAT(stated_beside_2021("auto M = glm::lookAt(vec3(0, 1, 4), vec3(0), vec3(0, 1, 0));"),
                ElementsAre("eye = (0, 1, 4)"));
    EXPECT_THAT(stated_beside_2021("const Triangle triangle{{0, -2, 2}, {2, 2, 1}, {-2, 2, 2}};"),
                ElementsAre("B = (2, 2, 1)"));
    EXPECT_THAT(stated_beside_2021("const Sphere sphere{{1, 0, 0}, 3};"),
                ElementsAre("center = (1, 0, 0)", "radius = 3"));
}

TEST(StatedScene, TellsTheSpheresCFromTheTriangles) {
    EXPECT_THAT(stated_beside_2021("vec3 C(1, 1, 1); vec3 A(0,-2,2), B(2,2,2); { vec3 C(-2, 2, 2); }"),
                ElementsAre("center = (1, 1, 1)"));
    EXPECT_THAT(stated_beside_2021("vec3 C(1, 1, 0); vec3 A(0,-2,2), B(2,2,2); { vec3 C(-2, 2, 3); }"),
                ElementsAre("C = (-2, 2, 3)"));
}

TEST(StatedScene, TakesCForTheCenterWhereTheThirdVertexIsStatedByAnotherName) {
    const std::string others = "vec3 eye(0, 0, 4), A(0, -2, 2), B(2, 2, 2); ";
    EXPECT_THAT(stated_beside_2021(others + "vec3 C(1, 1, 0.5), Cc(-2, 2, 2);"), ElementsAre("center = (1, 1, 0.5)"));
    EXPECT_THAT(stated_beside_2021(others + "vec3 C(-2, 2, 1);"), ElementsAre("C = (-2, 2, 1)"));
}

TEST(StatedScene, MayBeAtAnotherPixel) {
    EXPECT_THAT(stated_beside_2021("vec3 P = pixelToVCS(plane, 120, 100);"), ElementsAre("P_DCS = (120, 100)"));
    EXPECT_THAT(stated_beside_2021("vec3 P = pixelToVCS(plane, 150.5, 100.5);"), IsEmpty())
        << "the middle of the pixel";
}

TEST(StatedScene, IsTheAssignmentsIfThePartIsAlsoStatedRightly) {
    EXPECT_THAT(stated_beside_2021("vec3 eye(0, 0, 4); vec3 eyeOfSecondRun(1, 2, 3);"), IsEmpty());
}

TEST(StatedScene, IsDescribedByItsParts) {
    EXPECT_EQ(describe(stated_scenes("vec3 center(1, 1, 1);", scene_of_2021()).front().parts),
              "Your source sets center = (1, 1, 1), but the assignment has (1, 1, 0)");
    const auto all = stated_scenes("vec3 eye(1,2,3), lookat(1,0,0), center(2,0,0); float R = 1;", scene_of_2021());
    EXPECT_EQ(describe(all.front().parts),
              "Your source sets a different scene from this assignment's, perhaps another year's: eye = (1, 2, 3), "
              "lookat = (1, 0, 0), center = (2, 0, 0) and radius = 1");
}

TEST(StatedScene, ManyNumbersAreTriedForABoundedNumberOfScenes) {
    std::string source = "vec3 eye(1, 2, 3), center(4, 5, 6);";
    for (int i = 20; i < 2000; ++i) source += " f(" + std::to_string(i) + ", " + std::to_string(i + 7) + ");";
    EXPECT_LE(stated_scenes(source, scene_of_2021()).size(), 12U);
}

}  // namespace
}  // namespace harness::source
