// Hard scenes with a cylinder, judged by the certified key and the exact equations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "harness/stress/generate.h"
#include "harness/variants/random/draw.h"
#include "reference/stages/scene_answers.h"
#include "reference/toml/scene_toml.h"
#include "tests/harness/stress/generated.h"

namespace harness::stress {
namespace {

using reference::Certified;
using reference::CylinderPart;
using testing::HasSubstr;

reference::Assignment handout() {
    return reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
}

/// The handout's objects seen from above, through a pixel off the middle: the ray is parallel to nothing.
reference::Assignment off_axis() {
    reference::Assignment assignment = handout();
    assignment.scene.camera.eye = {decimal("7"), decimal("6"), decimal("5")};
    assignment.scene.pixel = {150, 190};
    return assignment;
}

reference::SceneAnswers<Certified> exact(const source::DecimalScene& scene) {
    return reference::answer_scene(reference::certified_scene(reference::rational_scene(scene)),
                                   reference::PixelConvention::centre, reference::Boundary::nonnegative);
}

double value(const Certified& x) {
    return x.enclosure().nearest;
}

/// How deep in the tube the ray passes: d = 4 a (R² - distance²).
double share(const reference::SceneAnswers<Certified>& answers, const source::DecimalScene& scene) {
    const auto& tube = answers.cylinder->equations.tube;
    const double radius = scene.cylinders.front().radius.to_double();
    return value(tube.d) / (4 * value(tube.a) * radius * radius);
}

/// 1 at the top cap's plane, -1 at the bottom cap's, where the ray enters the tube.
double height_at_tube(const reference::SceneAnswers<Certified>& answers, const source::DecimalScene& scene) {
    const auto& tube = answers.cylinder->equations.tube;
    const Certified t = *reference::root(tube, reference::RootChoice::smaller);
    const auto& cylinder = scene.cylinders.front();
    const double y = value(answers.camera.P_WCS.y + t * answers.camera.V.y) - cylinder.center.y.to_double();
    return y / (cylinder.height.to_double() / 2);
}

TEST(CylinderRecipes, HaveThePropertiesTheyAreNamedAfter) {
    for (const reference::Assignment& assignment : {handout(), off_axis()}) {
        SCOPED_TRACE(reference::scene_toml(assignment.scene));
        auto scenes = by_name(assignment, everything());
        const auto scene = [&](const char* name) { return scenes.at(name).scene.value(); };
        const auto part = [&](const char* name) { return exact(scene(name)).cylinder->part; };
        const auto answers = [&](const char* name) { return exact(scene(name)); };
        const auto near = [&](double x, double bound) { return x > 0 && x < bound; };
        EXPECT_EQ(part("cylinder, grazed"), CylinderPart::tube_smaller_root);
        EXPECT_TRUE(near(share(answers("cylinder, grazed"), scene("cylinder, grazed")), 1e-4));
        EXPECT_EQ(part("cylinder, just missed"), CylinderPart::miss);
        EXPECT_TRUE(near(-share(answers("cylinder, just missed"), scene("cylinder, just missed")), 1e-4));
        const char* within = "cylinder, just within the rim";
        EXPECT_EQ(part(within), CylinderPart::tube_smaller_root);
        EXPECT_TRUE(near(1 - std::abs(height_at_tube(answers(within), scene(within))), 1e-3));
        const char* beyond = "cylinder, just beyond the rim";
        EXPECT_NE(part(beyond), CylinderPart::tube_smaller_root);
        EXPECT_TRUE(near(std::abs(height_at_tube(answers(beyond), scene(beyond))) - 1, 1e-3));
        const char* to_caps = "cylinder's cap, nearly parallel to the ray";
        EXPECT_TRUE(part(to_caps) == CylinderPart::top_cap || part(to_caps) == CylinderPart::bottom_cap);
        EXPECT_TRUE(near(std::abs(value(answers(to_caps).camera.V.y)), 0.01));
        const char* to_axis = "cylinder's axis, nearly parallel to the ray";
        EXPECT_EQ(part(to_axis), CylinderPart::tube_smaller_root);
        EXPECT_TRUE(near(value(answers(to_axis).cylinder->equations.tube.a), 0.01));
        const char* close = "ray starts close to the cylinder";
        EXPECT_EQ(part(close), CylinderPart::tube_smaller_root);
        EXPECT_TRUE(near(value(*answers(close).cylinder->t) / scene(close).cylinders.front().radius.to_double(), 1e-3));
        const auto far = answers("small cylinder, far away");
        EXPECT_GT(value(*far.cylinder->t), 9e4);
    }
}

TEST(CylinderRecipes, MeetRimAndStartExactlyWhereTheRayIsExact) {
    auto level = by_name(handout(), everything());
    const auto rim_of = [](const std::map<std::string, HardScene>& scenes) {
        return *exact(scenes.at("cylinder, through the rim").scene.value()).cylinder;
    };
    EXPECT_EQ(rim_of(level).part, CylinderPart::tube_smaller_root);
    EXPECT_EQ(value(rim_of(level).equations.top.numerator), 0) << "the ray runs in the top cap's plane";
    EXPECT_EQ(value(*exact(level.at("ray starts on the cylinder").scene.value()).cylinder->t), 0);
    reference::Assignment sloping = handout();  // V is (-3, -4, 0) / 5, and P_WCS (3, -3, 0)
    sloping.scene.camera.lookat = {decimal("3"), decimal("-3"), decimal("0")};
    sloping.scene.window.clip_near = decimal("5");
    const auto rim = rim_of(by_name(sloping, everything()));
    EXPECT_EQ(reference::cap_at_rim(rim.equations, rim.part), CylinderPart::top_cap);
    auto inexact = by_name(off_axis(), everything());
    EXPECT_THAT(inexact.at("cylinder, through the rim").why_not, HasSubstr("exact in decimals"));
}

// With the camera far from everything the cylinder comes along, in front of it.
TEST(CylinderRecipes, KeepTheCylinderBeforeAMovedCamera) {
    auto scenes = by_name(handout(), everything());
    for (const char* name : {"eye far away", "vup nearly along the view", "scene far from the origin"})
        EXPECT_TRUE(exact(scenes.at(name).scene.value()).cylinder->t.has_value()) << name;
}

}  // namespace
}  // namespace harness::stress
