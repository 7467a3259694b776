// Soft shadows and textures in the picture, compared with what geometry says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/render/picture/picture.h"
#include "tests/given/render/scenes.h"
#include "tests/given/temporary_folder.h"
#include "tests/reference/render/trace/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using scenes::clay;
using scenes::colors_of;
using scenes::material;
using scenes::prepared;
using scenes::sphere;
using scenes::triangle;
using scenes::with_camera;

std::vector<Color> as_called_for(const PreparedScene& scene) {
    return colors_of(scene, effects_of(decide_effects(scene)));
}

const std::string wall = triangle("[[-99, -99, -4], [99, -99, -4], [0, 99, -4]]", "clay");

std::string lamp_with(const std::string& more) {
    return "[[light]]\nposition = [0, 0, 8]\ncolor = [1, 0.5, 1]\n" + more;
}

TEST(AreaLights, WithOneSampleAreAPointLight) {
    const std::string objects = clay + wall + sphere("[0.6, 0.5, -2]", "0.75", "clay");
    const auto point = as_called_for(prepared(with_camera(lamp_with("") + objects)));
    EXPECT_EQ(
        as_called_for(prepared(with_camera(lamp_with("sides = [[1, 0, 0], [0, 1, 0]]\nsamples = 1\n") + objects))),
        point);
    EXPECT_EQ(
        as_called_for(prepared(with_camera(lamp_with("sides = [[0, 0, 0], [0, 0, 0]]\nsamples = 4\n") + objects))),
        point);
}

/// A screen with a straight edge at x = 0, halfway between a lamp of width 2 and the wall 12 behind it: the shadow's
/// edge is as wide as the lamp, and the share of the lamp that a point of the wall sees grows evenly across it.
TEST(AreaLights, CastShadowsWithTheSoftEdgeThatGeometryGives) {
    constexpr int per_side = 16;
    const std::string screen = triangle("[[0, -400, 2.5], [0, 400, 2.5], [-400, 0, 2.5]]", "clay");
    const auto colors_with = [&](const std::string& light, const std::string& objects) {
        // The camera looks at the wall from behind the screen.
        return as_called_for(prepared(
            "[camera]\neye = [0, 0, 2]\nlookat = [0, 0, -4]\nvup = [0, 1, 0]\n[window]\nclip_left = -1\nclip_right = "
            "1\nclip_bottom = -0.01\nclip_top = 0.01\nclip_near = 1\nwidth = 60\nheight = 1\npixel = [0, 0]\n" +
            light + objects));
    };
    const std::string light =
        "[[light]]\nposition = [0, 0, 9]\nsides = [[2, 0, 0], [0, 0, 0]]\nsamples = 256\n"
        "color = [1, 1, 1]\n";
    const auto shaded = colors_with(light, clay + wall + screen);
    const auto open = colors_with(light, clay + wall);
    int partly = 0;
    for (std::size_t i = 0; i < shaded.size(); ++i) {
        // The wall's x; the line from it to the lamp's x' passes the screen's plane in the middle, at (x + x') / 2.
        const double x = (-1 + 2 * (static_cast<double>(i) + 0.5) / 60) * 6;
        const double seen = std::clamp((1 + x) / 2, 0.0, 1.0);
        EXPECT_NEAR(shaded[i].x / open[i].x, seen, 1.5 / per_side) << x;
        partly += 0.1 < seen && seen < 0.9 ? 1 : 0;
    }
    EXPECT_GT(partly, 5);
}

class TexturedScene : public testing::Test {
  protected:
    std::string textured(const std::string& properties, const std::string& objects) const {
        return with_camera("[render]\nambient_light = [1, 1, 1]\n" +
                           material("paper", "ambient = [1, 0.5, 1]\n" + properties) + objects);
    }
    /// A texture whose left half is black and whose right half is white.
    std::string file() const {
        std::vector<std::uint8_t> bytes(300, 0);
        std::fill(bytes.begin() + 150, bytes.end(), 255);
        return fmt::format("texture = \"{}\"\n", folder_.write("halves.png", to_png({100, 1, bytes})).string());
    }

  private:
    TemporaryFolder folder_;
};

TEST_F(TexturedScene, ShowsATextureAcrossAPlane) {
    const PreparedScene scene = prepared(textured(file() + "texture_across = [0.125, 0, 0]\n",
                                                  triangle("[[-99, -99, 0], [99, -99, 0], [0, 99, 0]]", "paper")));
    EXPECT_EQ(effects_of(decide_effects(scene)), (Effects{true, false, false, false, false, true}));
    const auto colors = as_called_for(scene);
    EXPECT_EQ(colors, colors_of(scene, all_effects));
    EXPECT_NE(colors, colors_of(scene, {true, false, false, false, false, false}));
    for (std::size_t i = 0; i < colors.size(); ++i) {
        // The wall is twice as far as the window, whose pixels are 0.1 wide.
        const double x = 2 * (-2 + 0.1 * (static_cast<double>(i % 40) + 0.5));
        if (std::abs(x) < 0.2 || std::abs(x) > 3.8) continue;  // where the texture changes
        EXPECT_NEAR(colors[i].x, x < 0 ? 1 : 0, 1e-12) << x;
        EXPECT_NEAR(colors[i].y, x < 0 ? 0.5 : 0, 1e-12) << x;
    }
}

/// Longitude 0 is towards the camera, on +z, and grows towards +x: the right half of the ball shows the texture's left.
TEST_F(TexturedScene, WrapsATextureAroundASphere) {
    const PreparedScene scene = prepared(textured(file(), sphere("[0, 0, 0]", "1", "paper")));
    const auto colors = as_called_for(scene);
    EXPECT_NEAR(colors[15 * 40 + 16].x, 1, 1e-12);
    EXPECT_NEAR(colors[15 * 40 + 23].x, 0, 1e-12);
}

TEST_F(TexturedScene, NeedsNoTexelWhereNothingScatters) {
    const std::string mirror = "reflectivity = 1\n" + file();
    EXPECT_FALSE(effects_of(decide_effects(prepared(textured(mirror, sphere("[0, 0, 0]", "1", "paper"))))).textures);
    const std::string unused = file();
    EXPECT_FALSE(effects_of(decide_effects(prepared(textured(unused, sphere("[0, 0, 0]", "1"))))).textures);
}

}  // namespace
