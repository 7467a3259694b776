// No ray is shot whose answer is known or would be multiplied by 0.
#include <gtest/gtest.h>

#include "reference/render/picture.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using scenes::clay;
using scenes::lamp;
using scenes::material;
using scenes::prepared;
using scenes::sphere;
using scenes::with_camera;

const std::string black = material("black", "ambient = [1, 1, 1]");
const std::string mirror = material("mirror", "diffuse = [1, 1, 1]\nreflectivity = 1");

Work work_of(const PreparedScene& scene) {
    return render::render(scene, effects_of(decide_effects(scene)), 1).work;
}

TEST(RefractedRays, AreNotShotThroughALonePane) {
    const std::string glass = material("glass", "transparency = 0.9");
    const PreparedScene pane = prepared(
        with_camera(glass + "[[triangle]]\nvertices = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]\nmaterial = \"glass\"\n"));
    EXPECT_EQ(work_of(pane).refracted_rays, 0U);
    EXPECT_GT(work_of(prepared(with_camera(glass + sphere("[0, 0, 0]", "1", "glass")))).refracted_rays, 0U);
}

TEST(ShadowRays, AreNotShotFromAPerfectMirrorOrABlackBall) {
    const PreparedScene scene = prepared(with_camera(lamp + mirror + black + sphere("[-1, 0, 0]", "0.8", "mirror") +
                                                     sphere("[1, 0, 0]", "0.8", "black")));
    EXPECT_EQ(work_of(scene).shadow_rays, 0U);
    EXPECT_GT(work_of(scene).mirrored_rays, 0U);
    // Where another ball needs shadow rays.
    const std::string white = material("white", "diffuse = [1, 1, 1]") + sphere("[0, 0, -3]", "0.8", "white");
    const PreparedScene with_white =
        prepared(with_camera(lamp + mirror + white + sphere("[-1, 0, 0]", "0.8", "mirror")));
    EXPECT_GT(work_of(with_white).shadow_rays, 0U);
}

/// Red light on a blue ball.
TEST(ShadowRays, AreNotShotWhereNoColorIsCommonToLightAndMaterial) {
    const std::string red = "[[light]]\nposition = [2, 3, 3]\ncolor = [1, 0, 0]\n";
    const std::string blue = material("blue", "ambient = [1, 1, 1]\ndiffuse = [0, 0, 1]");
    const auto scene_with = [&](const std::string& lights) {
        return prepared(
            with_camera(lights + blue + sphere("[-1, 0, 0]", "0.8", "blue") + sphere("[1, 0, 0]", "0.8", "blue")));
    };
    EXPECT_EQ(work_of(scene_with(red)).shadow_rays, 0U);
    EXPECT_FALSE(effects_of(decide_effects(scene_with(red))).shadows);
    const std::uint64_t by_white_light = work_of(scene_with(lamp)).shadow_rays;
    EXPECT_GT(by_white_light, 0U);
    EXPECT_EQ(work_of(scene_with(lamp + red)).shadow_rays, by_white_light);
}

/// The lamp is outside the glass ball, which is opaque for shadow rays. So the inside needs none, and there are as many
/// as for a ball that lets nothing through.
TEST(ShadowRays, AreNotShotFromInsideTheSphereThatBlocksThem) {
    const auto scene_with = [&](const std::string& property) {
        return prepared(with_camera(lamp + clay + material("ball", "diffuse = [1, 1, 1]\n" + property) +
                                    sphere("[0, 0, 0]", "1", "ball") + sphere("[0, 9, 0]", "0.1", "clay")));
    };
    const std::uint64_t solid = work_of(scene_with("")).shadow_rays;
    EXPECT_GT(solid, 0U);
    EXPECT_GT(work_of(scene_with("transparency = 0.9")).refracted_rays, 0U);
    EXPECT_EQ(work_of(scene_with("transparency = 0.9")).shadow_rays, solid);
}

/// A lamp inside the ball lights the inside.
TEST(ShadowRays, AreShotInsideASphereToALampInIt) {
    const std::string inner = "[[light]]\nposition = [0, 0.5, 0]\ncolor = [1, 1, 1]\n";
    const PreparedScene scene =
        prepared(with_camera(inner + clay + sphere("[0, 0, 0]", "9", "clay") + sphere("[0, 0, 8]", "0.2", "clay")));
    EXPECT_EQ(work_of(scene).shadow_rays, 40U * 30U);
}

/// What leaves the only object meets nothing, and the object's own far side is no search.
TEST(Rays, AreNotShotAwayFromTheOnlyObject) {
    const PreparedScene ball = prepared(with_camera(lamp + mirror + sphere("[0, 0, 0]", "1", "mirror")));
    EXPECT_EQ(work_of(ball).mirrored_rays, 0U);
    const std::string glass = material("glass", "diffuse = [1, 1, 1]\ntransparency = 0.9\nrefractive_index = 1.5");
    const PreparedScene drop = prepared(with_camera(lamp + glass + sphere("[0, 0, 0]", "1", "glass")));
    EXPECT_EQ(work_of(drop).shadow_rays, 0U);
    EXPECT_GT(work_of(drop).refracted_rays, 0U) << "into the ball";
}

TEST(Rays, ShowTheBackgroundInAMirrorThatIsTheOnlyObject) {
    const PreparedScene scene = prepared(
        with_camera("[render]\nbackground = [0.25, 0.5, 0.75]\n" + mirror + sphere("[0, 0, 0]", "1", "mirror")));
    for (const Color& color : scenes::colors_of(scene, effects_of(decide_effects(scene)))) {
        EXPECT_EQ(color, Color(0.25, 0.5, 0.75));
    }
}

}  // namespace
