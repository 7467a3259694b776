// Which cylinder a source states, where it is not the assignment's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/scenes/source/stated_scene.h"
#include "reference/toml/assignment.h"

namespace harness::scenes {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const DecimalScene& handout() {
    static const DecimalScene a6 = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS).scene;
    return a6;
}

/// The parts of the likeliest scene: "cylinder radius = 3".
std::vector<std::string> parts(const std::string& source) {
    std::vector<std::string> texts;
    const auto scenes = stated_scenes(source, handout());
    if (scenes.empty()) return texts;
    for (const OtherPart& part : scenes.front().parts) texts.push_back(part.name + " = " + part.stated);
    return texts;
}

TEST(StatedCylinder, IsTheAssignmentsInEverySpelling) {
    EXPECT_THAT(parts("Sphere s{{1, 0, 1}, 2}; Cylinder c{{2, 0, 0}, 1, 4};"), IsEmpty());
    EXPECT_THAT(parts("vec3 center(1, 0, 1); float R = 2; vec3 cylCenter(2, 0, 0); float radius = 1, cylHeight = 4;"),
                IsEmpty());
    EXPECT_THAT(parts("float halfHeight = 2, cyl_h = 2;"), IsEmpty());
    EXPECT_THAT(parts("vec3 cylNormal(0, 1, 0), cylTop(2, 2, 0);"), IsEmpty()) << "neither is its center";
}

TEST(StatedCylinder, HasThePartThatIsCopiedWrongly) {
    EXPECT_THAT(parts("vec3 cylCenter(2, 0, 1);"), ElementsAre("cylinder center = (2, 0, 1)"));
    EXPECT_THAT(parts("float cylinderRadius = 3;"), ElementsAre("cylinder radius = 3"));
    EXPECT_THAT(parts("float cyl_height = 5;"), ElementsAre("cylinder height = 5"));
    EXPECT_THAT(parts("float halfHeight = 3; int H = 301;"), ElementsAre("cylinder height = 6"));
    EXPECT_THAT(parts("const Cylinder cylinder{{2, 1, 0}, 1, 3};"),
                ElementsAre("cylinder center = (2, 1, 0)", "cylinder height = 3"));
}

TEST(StatedCylinder, IsToldFromSphereAndWindow) {
    EXPECT_THAT(parts("float R = 2, radius = 3;"), ElementsAre("cylinder radius = 3"));
    EXPECT_THAT(parts("float R = 3, radius = 1;"), ElementsAre("radius = 3"));
    EXPECT_THAT(parts("int H = 300; float cylHeight = 4;"), ElementsAre("H = 300"));
    EXPECT_THAT(parts("int H = 301; float height = 5;"), ElementsAre("cylinder height = 5"));
    EXPECT_THAT(parts("float top = 1, bottom = -1, cylTop = 2, cylBottom = -2;"), IsEmpty());
}

}  // namespace
}  // namespace harness::scenes
