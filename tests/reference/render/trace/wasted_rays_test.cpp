// No ray is shot whose answer is known or would be multiplied by 0.
#include "reference/render/trace/wasted_rays.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "reference/render/picture/picture.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/trace/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using scenes::clay;
using scenes::material;
using scenes::prepared;
using scenes::sphere;
using scenes::with_camera;

constexpr std::uint64_t all = ~std::uint64_t{0};

const std::string lamp = "[[light]]\nposition = [2, 3, 3]\ncolor = [1, 1, 1]\n";
const std::string black = material("black", "ambient = [1, 1, 1]");
const std::string mirror = material("mirror", "diffuse = [1, 1, 1]\nreflectivity = 1");

RayCounts rays_of(const PreparedScene& scene) {
    return render::render(scene, effects_of(decide_effects(scene)), 1).rays;
}

void expect_no_waste(const PreparedScene& scene, std::uint64_t most) {
    const WastedRays rays = wasted_rays(scene, most);
    EXPECT_GT(rays.looked_at, 0U);
    EXPECT_EQ(rays.wasted, 0U) << "of " << rays.looked_at;
}

class EachRoom : public testing::TestWithParam<int> {};

TEST_P(EachRoom, ShootsNoRayForNothing) {
    const auto bit = [&](int i) { return (GetParam() >> i & 1) != 0; };
    expect_no_waste(prepared(scenes::room({true, bit(0), bit(1), bit(2), bit(3)})), 5'000);
}

INSTANTIATE_TEST_SUITE_P(All, EachRoom, testing::Range(0, 16));

TEST(WastedRays, AreNoneInTheScenesThatComeWithRaygrade) {
    for (const char* const name : {"shadowed.toml", "mirrors.toml", "glass.toml", "soft.toml", "columns.toml"}) {
        SCOPED_TRACE(name);
        expect_no_waste(prepare_scene(load_scene(std::filesystem::path(RAYGRADE_SCENES) / name), PictureSize{64, 36}),
                        20'000);
    }
}

/// As many as the loops shoot, each once.
TEST(WastedRays, AreLookedForAmongAllRays) {
    const PreparedScene scene = prepared(scenes::room({true, true, true, false, false}));
    const RayCounts rays = rays_of(scene);
    EXPECT_EQ(wasted_rays(scene, all).looked_at,
              rays.shadow + rays.mirrored + rays.refracted + rays.reflected_in_glass);
}

TEST(RefractedRays, AreNotShotThroughALonePane) {
    const std::string glass = material("glass", "transparency = 0.9");
    const PreparedScene pane = prepared(
        with_camera(glass + "[[triangle]]\nvertices = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]\nmaterial = \"glass\"\n"));
    EXPECT_EQ(rays_of(pane).refracted, 0U);
    EXPECT_GT(rays_of(prepared(with_camera(glass + sphere("[0, 0, 0]", "1", "glass")))).refracted, 0U);
}

/// A sample of some thousand rays is not traced once for each of them.
TEST(WastedRays, AreLookedForInBoundedTime) {
    std::string balls = material("tinted", "reflectivity = 0.4\ntransparency = 0.6");
    for (int i = 0; i < 6; ++i) balls += sphere("[" + std::to_string(i - 3) + ", 0, 0]", "0.6", "tinted");
    EXPECT_LE(wasted_rays(prepared(with_camera(lamp + balls)), 100).looked_at, 300U);
}

TEST(ShadowRays, AreNotShotFromAPerfectMirrorOrABlackBall) {
    const PreparedScene scene = prepared(with_camera(lamp + mirror + black + sphere("[-1, 0, 0]", "0.8", "mirror") +
                                                     sphere("[1, 0, 0]", "0.8", "black")));
    EXPECT_EQ(rays_of(scene).shadow, 0U);
    EXPECT_GT(rays_of(scene).mirrored, 0U);
    // Where another ball needs shadow rays.
    const std::string white = material("white", "diffuse = [1, 1, 1]") + sphere("[0, 0, -3]", "0.8", "white");
    const PreparedScene with_white =
        prepared(with_camera(lamp + mirror + white + sphere("[-1, 0, 0]", "0.8", "mirror")));
    EXPECT_GT(rays_of(with_white).shadow, 0U);
    expect_no_waste(with_white, all);
}

/// Red light on a blue ball.
TEST(ShadowRays, AreNotShotWhereNoColorIsCommonToLightAndMaterial) {
    const std::string red = "[[light]]\nposition = [2, 3, 3]\ncolor = [1, 0, 0]\n";
    const std::string blue = material("blue", "ambient = [1, 1, 1]\ndiffuse = [0, 0, 1]");
    const auto scene_with = [&](const std::string& lights) {
        return prepared(
            with_camera(lights + blue + sphere("[-1, 0, 0]", "0.8", "blue") + sphere("[1, 0, 0]", "0.8", "blue")));
    };
    EXPECT_EQ(rays_of(scene_with(red)).shadow, 0U);
    EXPECT_FALSE(effects_of(decide_effects(scene_with(red))).shadows);
    const std::uint64_t by_white_light = rays_of(scene_with(lamp)).shadow;
    EXPECT_GT(by_white_light, 0U);
    EXPECT_EQ(rays_of(scene_with(lamp + red)).shadow, by_white_light);
}

/// The lamp is outside the glass ball, which is opaque for shadow rays. So the inside needs none, and there are as many
/// as for a ball that lets nothing through.
TEST(ShadowRays, AreNotShotFromInsideTheSphereThatBlocksThem) {
    const auto scene_with = [&](const std::string& property) {
        return prepared(with_camera(lamp + clay + material("ball", "diffuse = [1, 1, 1]\n" + property) +
                                    sphere("[0, 0, 0]", "1", "ball") + sphere("[0, 9, 0]", "0.1", "clay")));
    };
    const std::uint64_t solid = rays_of(scene_with("")).shadow;
    EXPECT_GT(solid, 0U);
    EXPECT_GT(rays_of(scene_with("transparency = 0.9")).refracted, 0U);
    EXPECT_EQ(rays_of(scene_with("transparency = 0.9")).shadow, solid);
}

/// A lamp inside the ball lights the inside.
TEST(ShadowRays, AreShotInsideASphereToALampInIt) {
    const std::string inner = "[[light]]\nposition = [0, 0.5, 0]\ncolor = [1, 1, 1]\n";
    const PreparedScene scene =
        prepared(with_camera(inner + clay + sphere("[0, 0, 0]", "9", "clay") + sphere("[0, 0, 8]", "0.2", "clay")));
    EXPECT_EQ(rays_of(scene).shadow, 40U * 30U);
}

/// What leaves the only object meets nothing, and the object's own far side is no search.
TEST(Rays, AreNotShotAwayFromTheOnlyObject) {
    const PreparedScene ball = prepared(with_camera(lamp + mirror + sphere("[0, 0, 0]", "1", "mirror")));
    EXPECT_EQ(rays_of(ball).mirrored, 0U);
    const std::string glass = material("glass", "diffuse = [1, 1, 1]\ntransparency = 0.9\nrefractive_index = 1.5");
    const PreparedScene drop = prepared(with_camera(lamp + glass + sphere("[0, 0, 0]", "1", "glass")));
    EXPECT_EQ(rays_of(drop).shadow, 0U);
    EXPECT_GT(rays_of(drop).refracted, 0U) << "into the ball";
}

TEST(Rays, BringTheBackgroundFromTheOnlyObject) {
    const PreparedScene scene = prepared(
        with_camera("[render]\nbackground = [0.25, 0.5, 0.75]\n" + mirror + sphere("[0, 0, 0]", "1", "mirror")));
    for (const Color& color : scenes::colors_of(scene, effects_of(decide_effects(scene)))) {
        EXPECT_EQ(color, Color(0.25, 0.5, 0.75));
    }
}

}  // namespace
