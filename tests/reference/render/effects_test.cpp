// A scene gets only the effects it needs, and all of them: its picture exactly equals the picture with all effects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "reference/render/picture.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using scenes::clay;
using scenes::colors_of;
using scenes::cylinder;
using scenes::lamp;
using scenes::material;
using scenes::prepared;
using scenes::sphere;
using scenes::triangle;
using scenes::Wishes;
using scenes::with_camera;
using testing::HasSubstr;

Effects called_for(const PreparedScene& scene) {
    return effects_of(decide_effects(scene));
}

std::vector<std::uint64_t> bits(const std::vector<Color>& colors) {
    std::vector<std::uint64_t> result;
    for (const Color& color : colors) {
        for (int i = 0; i < 3; ++i) result.push_back(std::bit_cast<std::uint64_t>(color[i]));
    }
    return result;
}

void expect_same_as_all_effects(const PreparedScene& scene) {
    EXPECT_EQ(bits(colors_of(scene, called_for(scene))), bits(colors_of(scene, all_effects)));
}

class SubsetOfEffects : public testing::TestWithParam<int> {
  protected:
    Wishes wishes() const {
        const auto bit = [&](int i) { return (GetParam() >> i & 1) != 0; };
        return {bit(0), bit(1), bit(2), bit(3)};
    }
};

TEST_P(SubsetOfEffects, EqualsTheEffectsItsSceneNeeds) {
    const auto [light, mirror, glass, samples] = wishes();
    EXPECT_EQ(called_for(prepared(scenes::room(wishes()))), (Effects{light, light, mirror, glass, samples}));
}

TEST_P(SubsetOfEffects, GivesExactlyThePictureOfAllEffects) {
    expect_same_as_all_effects(prepared(scenes::room(wishes())));
}

/// Leaving out a needed effect changes the picture, so the test above can fail.
TEST_P(SubsetOfEffects, ChangesThePictureIfOneEffectIsLeftOut) {
    const PreparedScene scene = prepared(scenes::room(wishes()));
    const Effects effects = called_for(scene);
    const auto whole = bits(colors_of(scene, effects));
    for (bool Effects::*const effect : {&Effects::illumination, &Effects::shadows, &Effects::mirrors,
                                        &Effects::refraction, &Effects::supersampling}) {
        if (!(effects.*effect)) continue;
        Effects fewer = effects;
        fewer.*effect = false;
        EXPECT_NE(bits(colors_of(scene, fewer)), whole);
    }
}

/// Of each effect that the scene does not call for, nothing is computed; forced, it is, for the same picture.
TEST_P(SubsetOfEffects, CostsNoWorkForOtherEffects) {
    const auto [light, mirror, glass, samples] = wishes();
    const PreparedScene scene = prepared(scenes::room(wishes()));
    const Rendering own = render::render(scene, called_for(scene), 1);
    EXPECT_EQ(own.work.camera_rays, 40U * 30U * (samples ? 4U : 1U));
    EXPECT_EQ(own.work.shaded > 0, light);
    EXPECT_EQ(own.work.shadow_rays > 0, light);
    EXPECT_EQ(own.work.mirrored_rays > 0, mirror);
    EXPECT_EQ(own.work.refracted_rays > 0, glass);
    EXPECT_EQ(own.work.rays_reflected_in_glass > 0, glass);
    const Rendering all = render::render(scene, all_effects, 1);
    EXPECT_EQ(all.picture.bytes, own.picture.bytes);
    EXPECT_EQ(all.work.camera_rays, own.work.camera_rays);
    EXPECT_GE(all.work.shaded, own.work.shaded);
    EXPECT_GE(all.work.shadow_rays, own.work.shadow_rays);
    EXPECT_GT(all.work.mirrored_rays, own.work.mirrored_rays);
    EXPECT_GT(all.work.refracted_rays, own.work.refracted_rays);
    EXPECT_EQ(all.work.rays_reflected_in_glass > 0, glass);
}

/// What is turned off costs nothing either, whatever the scene calls for.
TEST(Effects, CostNoWorkWhereTheyAreOff) {
    const PreparedScene scene = prepared(scenes::room({true, true, true, true}));
    const auto work_without = [&](bool Effects::*effect) {
        Effects fewer = all_effects;
        fewer.*effect = false;
        return render::render(scene, fewer, 1).work;
    };
    const Work dark = work_without(&Effects::illumination);
    EXPECT_EQ(dark.shaded, 0U);
    EXPECT_EQ(dark.shadow_rays, 0U);
    EXPECT_GT(dark.mirrored_rays, 0U);
    EXPECT_EQ(work_without(&Effects::shadows).shadow_rays, 0U);
    EXPECT_EQ(work_without(&Effects::mirrors).mirrored_rays, 0U);
    const Work opaque = work_without(&Effects::refraction);
    EXPECT_EQ(opaque.refracted_rays, 0U);
    EXPECT_EQ(opaque.rays_reflected_in_glass, 0U);
    EXPECT_EQ(work_without(&Effects::supersampling).camera_rays, 40U * 30U);
    const Work visibility = render::render(scene, {}, 1).work;
    EXPECT_EQ(visibility, Work{.camera_rays = 40U * 30U});
}

INSTANTIATE_TEST_SUITE_P(All, SubsetOfEffects, testing::Range(0, 16));

std::string reason_for(const std::string& toml, std::string_view effect) {
    for (const Decision& decision : decide_effects(prepared(toml))) {
        if (decision.name == effect) return (decision.on ? "on: " : "off: ") + decision.reason;
    }
    return "no such effect";
}

const std::string sun = "[[light]]\ndirection = [1, 0, -1]\ncolor = [1, 1, 1]\n";

TEST(Effects, AreNoneForTheSceneOf2021) {
    const PreparedScene scene = scenes::prepared_assignment("a6-2021");
    EXPECT_EQ(called_for(scene), Effects{});
    const Rendering rendering = render::render(scene, called_for(scene), 1);
    EXPECT_EQ(rendering.work, Work{.camera_rays = 301U * 201U});
    expect_same_as_all_effects(scene);
}

TEST(Effects, AreGivenWithTheirReasons) {
    const std::string ball = sphere("[0, 0, 0]", "1", "clay");
    EXPECT_EQ(reason_for(with_camera(clay + ball), "illumination"), "off: no light: no shading, no shadow rays");
    EXPECT_EQ(reason_for(with_camera(clay + ball), "shadows"), "off: no light: no shading, no shadow rays");
    EXPECT_EQ(reason_for(with_camera(lamp + clay + ball), "shadows"),
              "off: one convex object: nothing can cast a shadow on another");
    EXPECT_EQ(reason_for(with_camera(lamp + clay + cylinder("[0, 0, 0]", "1", "2", "clay")), "shadows"),
              "off: one convex object: nothing can cast a shadow on another");
    EXPECT_EQ(reason_for(with_camera(lamp + clay + cylinder("[0, 0, 2]", "1", "2", "clay")), "shadows"),
              "on: a cylinder seen from inside is its own shade");
    EXPECT_EQ(reason_for(with_camera(lamp + clay + ball + sphere("[0, 3, 0]", "1", "clay")), "shadows"),
              "on: objects may stand between a light and each other");
    EXPECT_EQ(reason_for(with_camera(lamp + clay + ball), "mirrors"), "off: no reflectivity above 0: no mirrored rays");
    EXPECT_THAT(reason_for(with_camera(lamp + sphere("[0, 0, 0]", "1")), "illumination"), HasSubstr("no object has"));
    EXPECT_THAT(reason_for(with_camera("[render]\nambient_light = [1, 1, 1]\n" + clay + ball), "shadows"),
                HasSubstr("off: ambient light alone"));
    const std::string dull = material("clay", "ambient = [1, 1, 1]");
    EXPECT_THAT(reason_for(with_camera(lamp + dull + ball), "shadows"), HasSubstr("off: no material is diffuse"));
}

TEST(Effects, IgnoreAMaterialThatNoObjectHas) {
    const std::string glass = material("glass", "transparency = 1\nreflectivity = 0");
    EXPECT_EQ(called_for(prepared(with_camera(lamp + glass + sphere("[0, 0, 0]", "1")))), Effects{});
}

TEST(Effects, NeedNoShadowRaysForASingleObject) {
    for (const std::string& light : {lamp, sun}) {
        for (const std::string& object :
             {sphere("[0.2, 0.1, 0]", "1", "clay"), cylinder("[0.2, -0.5, 0]", "1", "1", "clay"),
              triangle("[[-1, -1, 0.5], [1, -1, -2], [0, 1, -1]]", "clay")}) {
            const PreparedScene scene = prepared(with_camera(light + clay + object));
            EXPECT_EQ(called_for(scene), (Effects{true, false, false, false, false}));
            expect_same_as_all_effects(scene);
        }
    }
}

/// The camera is inside a ball or a drum and the light outside, so it shades its whole inside.
TEST(Effects, NeedShadowsForAConvexObjectSeenFromInside) {
    for (const std::string& object : {sphere("[0, 0, 0]", "9", "clay"), cylinder("[0, 0, 0]", "9", "20", "clay")}) {
        const PreparedScene scene = prepared(with_camera(sun + clay + object));
        EXPECT_TRUE(called_for(scene).shadows);
        for (const Color& color : colors_of(scene, called_for(scene))) EXPECT_EQ(color, Color(0, 0, 0));
        const auto lit = colors_of(scene, {true, false, false, false, false});
        EXPECT_TRUE(std::any_of(lit.begin(), lit.end(), [](const Color& color) { return color.x > 0; }));
    }
}

/// The window cuts the ball or the drum in two, so some rays start inside it.
TEST(Effects, NeedShadowsForAConvexObjectCutByTheWindow) {
    for (const char* middle : {"[0, 0, 2]", "[1.5, 0, 2.1]"}) {
        for (const std::string& object : {sphere(middle, "1", "clay"), cylinder(middle, "1", "1", "clay")}) {
            const PreparedScene scene = prepared(with_camera(sun + clay + object));
            EXPECT_TRUE(called_for(scene).shadows) << middle;
            expect_same_as_all_effects(scene);
        }
    }
}

}  // namespace
