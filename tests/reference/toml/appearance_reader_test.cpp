// The optional tables of a scene: their contents, their mistakes, and that they change no marks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/key/answer_key.h"
#include "reference/key/key_formats.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/toml/complaint.h"

namespace reference {
namespace {

using scenes::cylinder;
using scenes::material;
using scenes::sphere;
using scenes::triangle;
using testing::AllOf;
using testing::HasSubstr;

Appearance appearance_with(const std::string& rest) {
    return parse_assignment(scenes::with_camera(rest), "folder/scene.toml").appearance;
}

TEST(AppearanceReader, ReadsEveryTable) {
    const Appearance appearance = appearance_with(
        "[render]\nambient_light = [0.1, 0.2, 0.3]\nbackground = [0.4, 0.5, 0.6]\nsamples_per_pixel = 9\n"
        "[[light]]\nposition = [1, 2, 3]\ncolor = [4, 5, 6]\n[[light]]\ndirection = [0, -1, 0]\ncolor = [1, 1, 1]\n" +
        material("clay", "diffuse = [1, 0, 0.5]") +
        material("glass",
                 "ambient = [0.1, 0, 0]\nspecular = [1, 1, 1]\nshininess = 40\nreflectivity = 0.25\n"
                 "transparency = 0.75\nrefractive_index = 1.5") +
        sphere("[0, 0, 0]", "1", "glass") + triangle("[[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "clay") +
        cylinder("[0, 0, 0]", "1", "2") + cylinder("[0, 4, 0]", "1", "2", "glass"));
    EXPECT_EQ(appearance.ambient_light, Color(0.1, 0.2, 0.3));
    EXPECT_EQ(appearance.background, Color(0.4, 0.5, 0.6));
    EXPECT_EQ(appearance.samples_per_pixel, 9);
    EXPECT_EQ(appearance.point_lights.at(0).position, Vec3<double>(1, 2, 3));
    EXPECT_EQ(appearance.point_lights.at(0).color, Color(4, 5, 6));
    EXPECT_EQ(appearance.directional_lights.at(0).direction, Vec3<double>(0, -1, 0));
    EXPECT_EQ(appearance.materials.at(0).diffuse, Color(1, 0, 0.5));
    const Material& glass = appearance.materials.at(1);
    EXPECT_EQ(std::tie(glass.ambient, glass.diffuse, glass.specular),
              std::make_tuple(Color(0.1, 0, 0), Color(0, 0, 0), Color(1, 1, 1)));
    EXPECT_EQ(std::tie(glass.shininess, glass.refractive_index, glass.reflectivity, glass.transparency),
              std::make_tuple(40, 1.5, 0.25, 0.75));
    EXPECT_EQ(appearance.object_materials.at(Subject::sphere).at(0), 1U);
    EXPECT_EQ(appearance.object_materials.at(Subject::triangle).at(0), 0U);
    EXPECT_EQ(appearance.object_materials.at(Subject::cylinder).at(0), std::nullopt);
    EXPECT_EQ(appearance.object_materials.at(Subject::cylinder).at(1), 1U);
}

TEST(AppearanceReader, NamesLineKeyAndRemedy) {
    const std::string white = "color = [1, 1, 1]\n", at = "[[light]]\nposition = [0, 0, 0]\n",
                      gold = sphere("[0, 0, 0]", "1", "gold");
    const struct {
        std::string toml, key, words;
    } broken[] = {
        {"[[light]]\n" + white, "light[1].position", "give one of the two"},
        {at + "direction = [0, 0, 1]\n" + white, "light[1]", "one of"},
        {"[[light]]\ndirection = [0, 0, 0]\n" + white, "light[1].direction", "is zero"},
        {at, "light[1].color", "is missing"},
        {at + "color = [-1, 0, 0]\n", "color", "from 0 to"},
        {"[[light]]\nplace = [0, 0, 0]\n" + white, "light[1].place", "is not a known key"},
        {material("m", "diffuse = [1, 2, 0]"), "material[1].diffuse", "from 0 to 1"},
        {material("m", "ambient = [0, 0, 1.5]"), "material[1].ambient", "from 0 to 1"},
        {material("m", "specular = [1.5, 0, 0]"), "material[1].specular", "from 0 to 1"},
        {material("m", "reflectivity = 1.5"), "material[1].reflectivity", "from 0 to 1"},
        {material("m", "gloss = 1"), "material[1].gloss", "is not a known key"},
        {material("m", "shininess = 0"), "shininess", "whole number from 1"},
        {material("m", "reflectivity = 0.5\ntransparency = 0.6"), "reflectivity", "sum must be at most 1"},
        {material("m", "refractive_index = 0"), "refractive_index", "0.01"},
        {"[[material]]\ndiffuse = [1, 1, 1]\n", "material[1].name", "is missing"},
        {material("m", "") + material("m", ""), "material[2].name", "in two materials"},
        {gold, "sphere[1].material", "there is no such material"},
        {material("tin", "") + gold, "sphere[1].material", "not one of tin"},
        {"[render]\nbackground = [0, 2, 0]\n", "render.background", "from 0 to 1"},
        {"[render]\nsamples_per_pixel = 5\n", "render.samples_per_pixel", "a square"},
        {"[render]\nsamples_per_pixel = 289\n", "render.samples_per_pixel", "256"},
        {"[render]\nfog = 1\n", "render.fog", "is not a known key"},
    };
    for (const auto& [toml, key, words] : broken) {
        EXPECT_THAT(complaint_about(scenes::with_camera(toml), "folder/scene.toml"),
                    AllOf(HasSubstr("folder/scene.toml:"), HasSubstr(key), HasSubstr(words)));
    }
}

/// All optional tables together change nothing in an assignment's key.
TEST(AppearanceReader, LeavesTheAnswerKeyUnchanged) {
    const std::string objects =
        sphere("[0.4, 0.3, 0.1]", "1.1") + triangle("[[-2, -1, 0.7], [2, -1, -0.4], [0, 1.7, 0.3]]");
    const std::string looks = "[render]\nsamples_per_pixel = 4\n[[light]]\nposition = [1, 2, 3]\ncolor = [1, 1, 1]\n" +
                              material("glass", "transparency = 1");
    const auto key = [](const std::string& rest) {
        return to_json(make_key(parse_assignment(scenes::with_camera(rest), "scene.toml"), Precision::certified));
    };
    const std::string with_materials =
        sphere("[0.4, 0.3, 0.1]", "1.1", "glass") + triangle("[[-2, -1, 0.7], [2, -1, -0.4], [0, 1.7, 0.3]]", "glass");
    EXPECT_EQ(key(looks + with_materials), key(objects));
}

}  // namespace
}  // namespace reference
